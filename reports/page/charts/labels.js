// Names beside the points of a chart, where there is room; the label transform is Vega's, not Vega-Lite's.
import {FONT, isNarrow} from '../chart.js';

/** For Chart.draw: the spec must have a layer `points` whose rows carry `label`, and a layer `front`. */
export function withLabels(spec) {
  const group = spec.marks.find((m) => m.name === 'points_marks') ? spec : null;
  if (!group) throw new Error('labels: the point layer is missing');
  const front = group.marks.find((m) => m.name?.startsWith('front_')); // one line, or a group of them
  group.marks.push({
    type: 'text',
    interactive: false,
    from: {data: 'points_marks'},
    encode: {
      enter: {
        text: {field: 'datum.label'},
        fontSize: {value: isNarrow() ? 11 : 12},
        font: {value: FONT},
        fill: {value: 'var(--ink)'}
      }
    },
    transform: [
      {
        type: 'label',
        size: {signal: '[max(1, width), max(1, height)]'},
        avoidMarks: ['points_marks', front?.name].filter(Boolean),
        anchor: ['right', 'left', 'top', 'bottom', 'top-right', 'bottom-right', 'top-left', 'bottom-left'],
        offset: [5]
      }
    ]
  });
  return spec;
}
