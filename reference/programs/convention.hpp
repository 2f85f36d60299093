// In which words a program hears questions and gives answers.
#pragma once

#include "reference/programs/ask.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

/// How a question was understood, other than as it was meant.
enum class Hearing {
  as_asked,
  transposed,        ///< rotations the other way: conjugate quaternions, transposed matrices
  scalar_last,       ///< quaternions read as (x, y, z, w)
  rotation_first,    ///< the first three rows of K are the moments'
  bodies_exchanged,  ///< body a is b
};

/// About which points the moments are, and in which axes loads are given.
enum class Point { nodes, joint_points, origin, node_a };
enum class Axes { global, own_node, joint_frame_a };

struct Convention {
  Hearing hearing = Hearing::as_asked;
  Point point = Point::nodes;
  Axes axes = Axes::global;
  bool moments_first = false;
  bool answers_exchanged = false;            ///< the loads of a are given as those of b
  double force_scale = 1, moment_scale = 1;  ///< -1, -1: loads on the bodies

  /// In words, empty for ours: "loads are those on the bodies", ...
  std::vector<std::string> words() const;
  int oddities() const;  ///< how far from ours; the sign of all loads is none
};

/// Every hearing, point, axes and order, scales of one.
std::vector<Convention> conventions();

/// The question as a program of this hearing understands it.
Ask heard(const Ask& ask, Hearing hearing);

/// Loads of b before those of a.
TwelveLoads exchanged(const TwelveLoads& loads);

/// Our loads as a program of this convention gives them, scales apart. @param heard  what it understood
TwelveLoads in_their_words(const TwelveLoads& loads, const Ask& heard, const Convention& convention);

/// A program of this convention, made of a joint in ours: what `translated` takes back.
Answerer spoken(const Answerer& joint, const Convention& convention);

/// The program asked and answering in our convention: the question that is heard as it is meant, the answer
/// made ours.
Answerer translated(const Answerer& program, const Convention& convention);

}  // namespace halfway::reference
