// What the charts of large rotation and of lost digits share.
import {look} from '../../palette.js';

const FADED = 0.1;

export function colorOf(names, field, nameOf) {
  return {
    field,
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(nameOf(n)).color)}
  };
}

export const faded = (field, only) =>
  only
    ? {opacity: {condition: {test: `datum.${field} === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
export const hover = () => ({
  params: [{name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}],
  mark: {type: 'point', filled: true, size: 45, clip: true}
});
export const onHover = {opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0}};
