// Colours of the laws on the page of an advice.
import {look, paletteStyle} from '../../page/palette.js';

const colours = document.createElement('style');
colours.textContent = paletteStyle();
document.head.append(colours);
for (const mark of document.querySelectorAll('[data-law]'))
  if (mark instanceof SVGElement) mark.style.color = look(mark.dataset.law ?? '').color;
