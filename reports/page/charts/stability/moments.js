// Names of the types of moment (results.stability.kind.moments).
const LABELS = {
  fixed: 'fixed',
  follower: 'follower',
  semi_tangential: 'semi-tangential',
  quasi_tangential: 'quasi-tangential',
  dead_couples: 'dead couples'
};
/** @param {string} moment */
export const momentLabel = (moment) => LABELS[moment] ?? moment.replaceAll('_', ' ');
