// The accuracy contract of halfway/rotations/so3.hpp: one row per function and scalar.
#include "verify/oracle/findings.hpp"
#include "verify/oracle/so3_measure.hpp"

namespace halfway::verify {
namespace {

template <class T>
using Vec4 = Eigen::Matrix<T, 4, 1>;

struct Exp {
  static constexpr const char* name = "exp";
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    return so3::exp(theta);
  }
};
struct Gamma {
  static constexpr const char* name = "gamma";
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    return so3::gamma(theta);
  }
};
struct GammaInverse {
  static constexpr const char* name = "gamma_inverse";
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    return so3::gamma_inverse(theta);
  }
};
struct Cayley {
  static constexpr const char* name = "cayley";
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& zeta) {
    return so3::cayley(zeta);
  }
};
struct LogMatrix {
  static constexpr const char* name = "log_matrix";
  static constexpr Input input = Input::matrix;
  template <class T>
  static Vec3<T> apply(const Mat3<T>& R) {
    return so3::log(R);
  }
};
struct HalfMatrix {
  static constexpr const char* name = "half_matrix";
  static constexpr Input input = Input::matrix;
  template <class T>
  static Mat3<T> apply(const Mat3<T>& R) {
    return so3::half(R);
  }
};
struct CayleyInverse {
  static constexpr const char* name = "cayley_inverse";
  static constexpr Input input = Input::matrix;
  template <class T>
  static Vec3<T> apply(const Mat3<T>& R) {
    return so3::cayley_inverse(R);
  }
};
struct QuaternionOfMatrix {
  static constexpr const char* name = "quaternion";
  static constexpr Input input = Input::matrix;
  template <class T>
  static Vec4<T> apply(const Mat3<T>& R) {
    return as_vector(so3::quaternion(R));
  }
};
struct LogQuaternion {
  static constexpr const char* name = "log_quaternion";
  static constexpr Input input = Input::quaternion;
  template <class T>
  static Vec3<T> apply(const Vec4<T>& q) {
    return so3::log(as_quaternion(q));
  }
};
struct HalfQuaternion {
  static constexpr const char* name = "half_quaternion";
  static constexpr Input input = Input::quaternion;
  template <class T>
  static Vec4<T> apply(const Vec4<T>& q) {
    return as_vector(so3::half(as_quaternion(q)));
  }
};
struct MatrixOfQuaternion {
  static constexpr const char* name = "matrix";
  static constexpr Input input = Input::quaternion;
  template <class T>
  static Mat3<T> apply(const Vec4<T>& q) {
    return so3::matrix(as_quaternion(q));
  }
};

constexpr double kContract = 4;

template <class S, class Function>
void add_row(Checks& checks, const char* scalar, Scale scale) {
  const char* reason = scale == Scale::absolute ? "accuracy contract of so3.hpp: 4 eps, each entry, absolute"
                                                : "accuracy contract of so3.hpp: 4 eps of the largest entry";
  const std::string name = fmt::format("so3/{}/{}", Function::name, scalar);
  checks.push_back({name, "identities", [=]() -> std::vector<Finding> {
                      return {at_most(name, "so3", function_error<S, Function>(scale), kContract, "eps",
                                      Oracle::fifty_digits, reason)};
                    }});
}

template <class S>
void add_rows(Checks& checks, const char* scalar) {
  add_row<S, Exp>(checks, scalar, Scale::absolute);
  add_row<S, MatrixOfQuaternion>(checks, scalar, Scale::absolute);
  add_row<S, HalfMatrix>(checks, scalar, Scale::absolute);
  add_row<S, HalfQuaternion>(checks, scalar, Scale::absolute);
  add_row<S, Cayley>(checks, scalar, Scale::absolute);
  add_row<S, LogMatrix>(checks, scalar, Scale::largest_entry);
  add_row<S, LogQuaternion>(checks, scalar, Scale::largest_entry);
  add_row<S, QuaternionOfMatrix>(checks, scalar, Scale::largest_entry);
  add_row<S, Gamma>(checks, scalar, Scale::largest_entry);
  add_row<S, GammaInverse>(checks, scalar, Scale::largest_entry);
  add_row<S, CayleyInverse>(checks, scalar, Scale::largest_entry);
}

}  // namespace

void so3_table(Checks& checks) {
  add_rows<float>(checks, "float");
  add_rows<double>(checks, "double");
  add_rows<long double>(checks, "long_double");
}

}  // namespace halfway::verify
