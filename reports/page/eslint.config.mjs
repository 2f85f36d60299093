// Mistakes that a formatter does not see, and files and functions that have grown too large.
import js from '@eslint/js';
import globals from 'globals';

export default [
  {ignores: ['node_modules/**', 'results.d.ts', 'run.d.ts']},
  js.configs.recommended,
  {
    files: ['*.js', 'charts/**/*.js', 'dashboard/**/*.js', 'run/**/*.js', 'sections/**/*.js'],
    languageOptions: {globals: globals.browser}
  },
  {
    files: ['*.mjs', 'tools/*.mjs', 'tests/*.mjs', 'tests/*/*.mjs'],
    languageOptions: {globals: globals.node}
  },
  {
    files: ['tests/page.test.mjs', 'tests/dashboard/*.mjs', 'tests/run/*.mjs'], // what it hands to the page runs there
    languageOptions: {globals: globals.browser}
  },
  {
    rules: {
      complexity: ['error', 14],
      eqeqeq: 'error',
      'max-lines': ['error', {max: 300, skipBlankLines: true, skipComments: true}],
      'max-len': ['error', {code: 120, ignoreTemplateLiterals: true}],
      'no-implicit-coercion': 'error',
      'no-shadow': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error'
    }
  }
];
