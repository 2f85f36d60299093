# What the page of a run is made of, in its order: a module stands after those that it imports.
set(run_page_styles
  styles/style.css styles/charts.css styles/tables.css styles/pictures.css styles/plot.css run/run.css styles/media.css)
set(run_page_modules
  format.js palette.js account.js dom.js start.js turntable.js dashboard/scale.js dashboard/plot.js charts/solids/view3d.js
  run/poses.js run/run_data.js run/words.js run/lines.js run/curves.js run/solids.js run/view.js run/shape.js run/holding.js
  run/reactions.js run/energy.js
  run/answers.js run/run.js)
