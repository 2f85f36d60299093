#include "reference/numbers/linear_algebra.hpp"
#include "reference/numbers/precision.hpp"

#include <Eigen/LU>

namespace halfway::reference {

template <class T>
SmallMatrix<T> lu_solve(const SmallMatrix<T>& A, const SmallMatrix<T>& B) {
  return A.partialPivLu().solve(B);
}

template <class T>
SmallVector<T> lu_solve(const SmallMatrix<T>& A, const SmallVector<T>& b) {
  return lu_solve<T>(A, SmallMatrix<T>(b));
}

template <class T>
SmallMatrix<T> lu_inverse(const SmallMatrix<T>& A) {
  return lu_solve<T>(A, SmallMatrix<T>(SmallMatrix<T>::Identity(A.rows(), A.rows())));
}

template <class T>
SmallVector<T> lu_pivots(const SmallMatrix<T>& A) {
  return A.partialPivLu().matrixLU().diagonal();
}

template <class T>
T lu_determinant(const SmallMatrix<T>& A) {
  return A.partialPivLu().determinant();
}

#define HALFWAY_INSTANTIATE(T)                                                    \
  template SmallMatrix<T> lu_solve(const SmallMatrix<T>&, const SmallMatrix<T>&); \
  template SmallVector<T> lu_solve(const SmallMatrix<T>&, const SmallVector<T>&); \
  template SmallMatrix<T> lu_inverse(const SmallMatrix<T>&);                      \
  template SmallVector<T> lu_pivots(const SmallMatrix<T>&);                       \
  template T lu_determinant(const SmallMatrix<T>&);
HALFWAY_INSTANTIATE(double)
HALFWAY_INSTANTIATE(Real50)
#undef HALFWAY_INSTANTIATE

Eigen::Matrix<Real50, 6, 1> solved(const Eigen::Matrix<Real50, 6, 6>& J,
                                   const Eigen::Matrix<Real50, 6, 1>& r) {
  return lu_solve<Real50>(J, SmallVector<Real50>(r));
}

Eigen::Matrix<Real50, 6, 6> inverse_of(const Eigen::Matrix<Real50, 6, 6>& J) { return lu_inverse<Real50>(J); }

}  // namespace halfway::reference
