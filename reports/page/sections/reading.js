// How to read the numbers, and where they end.
import {h} from '../dom.js';

export function reading() {
  return h(
    'div',
    {class: 'columns'},
    h(
      'div',
      {},
      h(
        'p',
        {},
        h('strong', {}, 'Modelling error'),
        ' is how far a formulation is from the truth even with perfect arithmetic; ',
        h('strong', {}, 'numerical error'),
        'is how far double precision is from the same formula at 50 digits. The first is a ' +
          'choice of the engineer, the second is a quality of the code.'
      ),
      h(
        'p',
        {},
        h('strong', {}, 'Time'),
        'is processor time of one evaluation, the median of repetitions over poses of every ' +
          'angle; a result is checked before it is timed. An angular joint computes nothing ' +
          'linear, so compare within one kind.'
      ),
      h(
        'p',
        {},
        h('strong', {}, 'Verdicts.'),
        ' ',
        h('span', {class: 'mark pass'}, '✓ pass'),
        ': within its limit. ',
        h('span', {class: 'mark known_failure'}, '≈ known failure'),
        ': the formulation is known to break this property, and the size of the defect is held ' +
          'in a band so that a silent change is noticed. ',
        h('span', {class: 'mark fail'}, '✗ fail'),
        ': outside its limit or band. ',
        h('span', {class: 'mark left_out'}, '– left out'),
        ': not measured, with the reason.'
      )
    ),
    h(
      'div',
      {},
      h('h4', {}, 'What the numbers cannot tell'),
      h(
        'p',
        {},
        'The lumped joint is as good as the stiffness that it is given: a perfect formulation of ' +
          'a wrong stiffness is wrong. Elastic behaviour only: no damping, friction, creep or ' +
          'contact. '
      ),
      h(
        'p',
        {},
        'The modelling error is measured on one family of parts and loads; another shape, ' +
          'another load path or strains that are no longer small can change the order of the ' +
          'formulations. ',
        'Formulations that stand for other programs are written after their sources and manuals; ' +
          'where this report did not run the program itself, it says what the law does, not what ' +
          'the program does.'
      ),
      h(
        'p',
        {},
        'Times are from one machine, one compiler and one loop over joints held in cache; inside ' +
          'a solver memory, assembly and branching weigh as much. Differences below the spread are ' +
          'noise.'
      )
    )
  );
}
