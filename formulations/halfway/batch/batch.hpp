// Many joints at once: one formulation, kind and law, a table of poses in, tables of loads out.
//
//   Batch batch({.formulation = "invariant", .kind = Kind::angular});
//   batch.evaluate(joints, results, Output::tangent);
//
// Structure of arrays, unit quaternions (w, x, y, z), SI units, global axes. The widest instruction
// set of the machine is chosen at run time, or the one in the environment's HALFWAY_ISA. Nothing is
// read or written beyond the joints; nothing is checked but by validate().
#pragma once

#include "halfway/batch/isa.hpp"
#include "halfway/batch/loops/job.hpp"
#include "halfway/joint/pose.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace halfway::batch {

namespace detail {
struct Entry;
}

/// Linear: the upper triangle of the symmetric K by rows, 6 or 21 numbers. Odd polynomial per axis,
/// k1 e + k3 e^3 + k5 e^5: k1 of all axes, then k3, then k5, 9 or 18 numbers.
enum class LawForm { linear, polynomial };

/// What is computed. Rows of Results::loads, angular: m_b (m_a = -m_b); else f_b, m_a, m_b (f_a = -f_b).
/// Signs: q = dU/dx, internal loads: add -q to your equations of motion.
enum class Output {
  residual,     ///< loads alone
  tangent,      ///< and the distinct entries of the tangent, see tangent_rows
  tangent_144,  ///< and all 12 x 12 by rows, loads (f_a, m_a, f_b, m_b) by (x_a, w_a, x_b, w_b); not angular
  product,    ///< loads, and their derivative along Joints::direction in the rows of the tangent; double only
  compressed  ///< and what the tangent follows from, compressed_rows() numbers in blocks; double only
};

struct Model {
  std::string formulation;  ///< a name of the catalog
  Kind kind = Kind::angular;
  LawForm law = LawForm::linear;
  /// Demanded by formulations that have one, read by no other; as in Parameters.
  std::optional<double> xi{}, length{};
  int axis = 1;
};

/// What its kernel reads.
constexpr Parameters parameters(const Model& model) {
  const Parameters usual;
  return {model.xi.value_or(usual.xi), model.length.value_or(usual.length), model.axis};
}

constexpr int law_rows(Kind kind, LawForm law) {
  return kind == Kind::linear_angular ? (law == LawForm::linear ? 21 : 18) : law == LawForm::linear ? 6 : 9;
}
constexpr int load_rows(Kind kind) { return kind == Kind::angular ? 3 : 9; }
constexpr int direction_rows(Kind kind) { return kind == Kind::angular ? 6 : 12; }
/// Angular: d(m_b)/d(w_a), d(m_b)/d(w_b), by rows. Else for each of f_b, m_a, m_b: by x_b (by x_a the
/// opposite), by w_a, by w_b: 81 numbers.
constexpr int tangent_rows(Kind kind, Output output) {
  switch (output) {
    case Output::residual:
      return 0;
    case Output::tangent:
      return kind == Kind::angular ? 18 : 81;
    case Output::tangent_144:
      return 144;
    case Output::compressed:
      return 33;  // at most: Batch::compressed_rows()
    default:
      return load_rows(kind);
  }
}

inline constexpr int kJointsInBlock = 8;
constexpr long compressed_size(int rows, long count) {
  return (count + kJointsInBlock - 1) / kJointsInBlock * kJointsInBlock * rows;
}

/// A stride for `count` joints that does not make the rows of a table collide in the cache.
template <class T>
constexpr long padded_stride(long count) {
  constexpr long kLine = 64 / long(sizeof(T));
  const long lines = (count + kLine - 1) / kLine;
  return (lines | 1) * kLine;
}

/// Poses and laws of `count` joints.
template <class T>
struct Joints {
  long count = 0;
  Columns<const T> q_a{}, q_b{};  ///< 4 rows each
  Columns<const T> x_a{}, x_b{};  ///< 3 rows each, m; not read by angular joints
  Columns<const T> law{};         ///< law_rows; shared: one number a row (stride 1)
  bool law_per_joint = false;
  const BatchEnd<T>*a = nullptr, *b = nullptr;  ///< of all joints; none: the joint frames are the nodes
  Columns<const T> direction{};  ///< (w_a, w_b) or (x_a, w_a, x_b, w_b), for Output::product alone
};

template <class T>
struct Results {
  Columns<T> loads, tangent;
};

/// Past the caches where all results exceed the last of them and their rows allow it, always, or never.
enum class Streaming { automatic, always, never };

struct Options {
  int threads = 1;
  Streaming streaming = Streaming::automatic;
};

class Batch {
 public:
  /// @param isa  the widest to be used; none: HALFWAY_ISA or what the machine has. Throws
  /// std::invalid_argument: no such formulation, one that needs a xi or a length without it, an axis that is
  /// none, or an instruction set that this machine lacks.
  explicit Batch(const Model& model, std::optional<Isa> isa = {});

  /// Is there a batch of that name?
  static bool knows(std::string_view formulation);
  /// Does it demand Model::length? False of a name that there is no batch of.
  static bool needs_length(std::string_view formulation);

  /// What of a tangent tells the rest of it: 9 numbers of an angular joint (d(m_b)/d(w_b) by rows), 33 of
  /// others: the upper triangle of d(f_b)/d(x_b), d(f_b)/d(w_b), d(m_b)/d(x_b), d(m_b)/d(w_b); where there is
  /// a potential 21: the first two, and the upper triangle of d(m_b)/d(w_b). 0: not balanced, all are needed.
  /// Results::tangent then has blocks of kJointsInBlock joints: number c of joint i is its entry
  /// (i / 8 * rows + c) * 8 + i % 8; the last block is whole.
  static int compressed_rows(const Model& model);

  /// Rows of Output::tangent or tangent_144 from a compressed one and its loads; joints: the same positions.
  void expand(const Joints<double>& joints, const Results<double>& compressed, const Columns<double>& tangent,
              Output output) const;
  /// J v from the same, v in Joints::direction: the rows of Output::product. Neither call checks anything.
  void multiply(const Joints<double>& joints, const Results<double>& compressed,
                const Columns<double>& product) const;

  /// Throws std::invalid_argument where T has no code for this formulation (has()).
  template <class T>
  void evaluate(const Joints<T>& joints, const Results<T>& results, Output output,
                const Options& options = {}) const;

  template <class T>
  bool has(Output output) const;
  /// The instruction set that runs: a narrower one where the widest was not built for this formulation.
  template <class T>
  Isa isa(Output output) const;

  const Model& model() const { return model_; }
  /// Is there an energy whose derivative the loads are? The tangent is then symmetric but for the bracket of
  /// spins.
  bool has_potential() const;
  /// For code that fills and empties packs itself (assemble): the loop over whole packs of `lanes` doubles,
  /// for joints with ends or without.
  detail::PackLoop loop(Output output, bool ends) const;

 private:
  template <class T>
  struct Code {
    const detail::Functions<T>* functions = nullptr;
    Isa isa = Isa::sse2;
  };
  template <class T>
  Code<T> code(Output output) const;

  Model model_;
  Isa widest_;
  const detail::Entry* served_by_;
};

/// The first thing that is wrong with a batch: which joint, which row, and the number found there.
/// Arrays too short, numbers that are not finite, quaternions that are not of unit length, offsets of one
/// end alone, tables that an output needs and that are missing. Throws std::invalid_argument.
template <class T>
void validate(const Model& model, const Joints<T>& joints, const Results<T>& results, Output output);
/// Of the same, what is said of the laws' numbers and of the ends: no pose and no result is looked at.
template <class T>
void validate_laws(const Model& model, const Joints<T>& joints);

namespace detail {
/// The length of a quaternion that is not one of a rotation, a NaN too.
template <class T>
std::optional<double> wrong_length(const T (&q)[4]);
}  // namespace detail

}  // namespace halfway::batch
