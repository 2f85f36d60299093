// What a type has to be to stand in the catalog; a line of it is refused in one sentence otherwise.
#pragma once

#include "halfway/joint/facts.hpp"
#include "halfway/joint/family.hpp"

namespace halfway {

namespace detail {

template <class F>
concept Named = requires {
  { F::name } -> std::convertible_to<const char*>;
  { F::stands_for } -> std::convertible_to<const char*>;
};

template <class F>
concept WithFacts = requires {
  { F::facts } -> std::convertible_to<Facts>;
};

template <class F>
concept WithPotential = requires(Kind kind) {
  { F::has_potential(kind) } -> std::same_as<bool>;
};

template <class F>
concept WithPath = requires {
  { F::kLinearWithoutRotation } -> std::convertible_to<bool>;
};

template <class F, Kind kind>
concept Straining = requires(const F& f, const RelativeMotion<double>& m) {
  { f.template strain<kind>(m) } -> std::convertible_to<Strain<double, kind>>;
};

template <class F>
concept Turning = requires(const F& f, const RelativeMotion<double>& m, const LinearLaw<double, 3>& law) {
  { f.template angular<true>(m, law) } -> std::same_as<AngularResponse<double>>;
  { f.template angular<false>(m, law) } -> std::same_as<AngularResponse<double>>;
};

template <class F, Kind kind>
concept Loading = requires(const F& f, const RelativeMotion<double>& m,
                           const LinearLaw<double, strain_count(kind)>& law) {
  { f.template point<kind, true>(m, law) } -> std::same_as<PointResponse<double>>;
  { f.template point<kind, false>(m, law) } -> std::same_as<PointResponse<double>>;
};

}  // namespace detail

/// A formulation of joints: names and facts, strains of each kind, and loads of them at the joint points.
template <class F>
concept Formulation = detail::Named<F> && detail::WithFacts<F> && detail::WithPotential<F> &&
    detail::WithPath<F> && detail::Straining<F, Kind::angular> && detail::Straining<F, Kind::linear> &&
    detail::Straining<F, Kind::linear_angular> && detail::Turning<F> && detail::Loading<F, Kind::linear> &&
    detail::Loading<F, Kind::linear_angular>;

/// Compiles for a formulation; names the first missing member of anything else.
template <class F>
constexpr void check_formulation() {
  static_assert(detail::Named<F>, "a formulation of the catalog has texts `name` and `stands_for`");
  static_assert(detail::WithFacts<F>, "a formulation of the catalog has `static constexpr Facts facts`");
  static_assert(detail::WithPotential<F>,
                "a formulation of the catalog has `static constexpr bool has_potential(Kind)`");
  static_assert(detail::WithPath<F>,
                "a formulation of the catalog has `static constexpr bool kLinearWithoutRotation`: "
                "does its linear joint need no relative rotation?");
  static_assert(
      detail::Straining<F, Kind::angular> && detail::Straining<F, Kind::linear> &&
          detail::Straining<F, Kind::linear_angular>,
      "a formulation of the catalog has `Strain<T, kind> strain<kind>(const RelativeMotion<T>&) const`");
  static_assert(detail::Turning<F>,
                "a formulation of the catalog has `AngularResponse<T> angular<with_tangent>(const "
                "RelativeMotion<T>&, const Law&) const`");
  static_assert(detail::Loading<F, Kind::linear> && detail::Loading<F, Kind::linear_angular>,
                "a formulation of the catalog has `PointResponse<T> point<kind, with_tangent>(const "
                "RelativeMotion<T>&, const Law&) const`");
}

}  // namespace halfway
