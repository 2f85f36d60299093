// What changed since the last release.
import {folded, h} from '../dom.js';
import {plural} from '../format.js';
import {changesTable} from './changes.js';
import {nothing, runWords} from './pieces.js';

/** @typedef {import('./dashboard.js').App} App */

const kListed = 100; // commits

/** @param {App} app */
export function releaseSection(app) {
  const {history, place} = app;
  const body = h('div');
  const show = () => {
    const {release} = history;
    if (!release) {
      body.replaceChildren(nothing('No run in this history is a release.'));
      return;
    }
    const since = place.series.runs.filter((run) => run > release.run);
    const changes = history.changesOf(place.series.number, (c) => c.run > release.run);
    const worse = changes.filter((c) => c.verdict === 'regression').length;
    const words = [
      `Since release ${release.name} (${history.commit(release.run)}, ${history.day(release.run)}): `,
      `${plural(since.length, 'run')}, ${worse} worse, ${changes.length - worse} better. `
    ];
    const newest = [...since].reverse().slice(0, kListed);
    body.replaceChildren(
      h('p', {class: 'answer'}, words),
      changes.length ? changesTable(app, `Changes since release ${release.name}`, changes) : '',
      since.length
        ? folded(
            `The ${newest.length < since.length ? `last ${newest.length} of ${plural(since.length, 'run')}` : plural(since.length, 'run')}`,
            h(
              'ol',
              {class: 'commits', reversed: true, start: since.length},
              newest.map((run) => h('li', {}, `${history.day(run)} `, runWords(app, run)))
            )
          )
        : ''
    );
  };
  return {content: body, show};
}
