import {launch} from './tests/browser.mjs';
const b=await launch();
for (const [f,o,y,h,w] of [['/tmp/look1/390-dark.png','/tmp/c1.png',0,1500,390],['/tmp/look2/1400-light.png','/tmp/c2.png',0,1700,1400],['/tmp/look2/820-dark.png','/tmp/c3.png',0,1900,820],['/tmp/look2/390-light.png','/tmp/c4.png',0,1700,390]]){
 const p=await b.newPage({viewport:{width:w,height:h}}); await p.setContent(`<body style="margin:0"><div style="height:${h}px;overflow:hidden"><img src="data:image/png;base64,${(await import('node:fs')).readFileSync(f).toString('base64')}" style="display:block;margin-top:-${y}px"></div>`); await p.waitForTimeout(300); await p.screenshot({path:o}); await p.close(); }
await b.close();
