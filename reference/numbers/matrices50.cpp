#include "reference/numbers/matrices50.hpp"

#include "reference/numbers/dual.hpp"
#include "reference/numbers/precision.hpp"

namespace halfway::reference {

template <class T, int m, int n>
using Plain = Eigen::Matrix<T, m, n>;
template <class T, int m, int n>
using Turned = Eigen::Transpose<const Eigen::Matrix<T, n, m>>;

template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Plain<T, m, n>
operator*(const Plain<T, m, k>& a, const Plain<T, k, n>& b) { return a.lazyProduct(b); }

template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Plain<T, m, n>
operator*(const Turned<T, m, k>& a, const Plain<T, k, n>& b) { return a.lazyProduct(b); }

template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Plain<T, m, n>
operator*(const Plain<T, m, k>& a, const Turned<T, k, n>& b) { return a.lazyProduct(b); }

template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Plain<T, m, n>
operator*(const T& s, const Plain<T, m, n>& a) {
  return a.unaryExpr([&](const T& x) { return T(s * x); });
}

template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Plain<T, m, n>
operator+(const Plain<T, m, n>& a, const Plain<T, m, n>& b) { return a.binaryExpr(b, std::plus<T>()); }

template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Plain<T, m, n>
operator-(const Plain<T, m, n>& a, const Plain<T, m, n>& b) { return a.binaryExpr(b, std::minus<T>()); }

template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Plain<T, m, n>
operator-(const Plain<T, m, n>& a) { return a.unaryExpr(std::negate<T>()); }

#define HALFWAY_PRODUCTS(T, m, k, n)                                                \
  template Plain<T, m, n> operator*(const Plain<T, m, k>&, const Plain<T, k, n>&);  \
  template Plain<T, m, n> operator*(const Turned<T, m, k>&, const Plain<T, k, n>&); \
  template Plain<T, m, n> operator*(const Plain<T, m, k>&, const Turned<T, k, n>&);
#define HALFWAY_SUMS(T, m, n)                                                      \
  template Plain<T, m, n> operator*(const T&, const Plain<T, m, n>&);              \
  template Plain<T, m, n> operator+(const Plain<T, m, n>&, const Plain<T, m, n>&); \
  template Plain<T, m, n> operator-(const Plain<T, m, n>&, const Plain<T, m, n>&); \
  template Plain<T, m, n> operator-(const Plain<T, m, n>&);
#define HALFWAY_SIZES(T)       \
  HALFWAY_PRODUCTS(T, 3, 3, 3) \
  HALFWAY_PRODUCTS(T, 3, 3, 1) \
  HALFWAY_PRODUCTS(T, 3, 1, 3) \
  HALFWAY_PRODUCTS(T, 6, 6, 1) \
  HALFWAY_SUMS(T, 3, 1)        \
  HALFWAY_SUMS(T, 3, 3)        \
  HALFWAY_SUMS(T, 6, 1)        \
  HALFWAY_SUMS(T, 6, 6)

HALFWAY_SIZES(Real50)
HALFWAY_SIZES(Dual<Real50>)

}  // namespace halfway::reference
