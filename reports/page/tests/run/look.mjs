// Pictures of the page of a run, to be looked at: both themes, wide and narrow, and the first screen.
//   npm run look-run -- out/run/NAME/index.html FOLDER
import {mkdirSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {launch} from '../browser.mjs';

const [file, folder] = process.argv.slice(2);
if (!folder) throw new Error('usage: npm run look-run -- PAGE FOLDER');
mkdirSync(folder, {recursive: true});
const browser = await launch();
for (const width of [400, 1400]) {
  for (const theme of ['light', 'dark']) {
    const page = await browser.newPage({viewport: {width, height: 880}});
    await page.goto(`${pathToFileURL(resolve(file)).href}?theme=${theme}`);
    await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading');
    await page.screenshot({path: join(folder, `${width}-${theme}.png`)});
    await page.screenshot({path: join(folder, `${width}-${theme}-whole.png`), fullPage: true});
    await page.close();
  }
}
await browser.close();
