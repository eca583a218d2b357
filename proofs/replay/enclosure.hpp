#pragma once

#include <arb.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/replay/statement.hpp"

namespace delcert::replay {

/// An end of a set of real numbers: a number of Arb or infinite, and whether it can be a value itself.
class End {
 public:
  End() { arf_init(value_); }
  End(const End& other) : is_open(other.is_open) {
    arf_init(value_);
    arf_set(value_, other.value_);
  }
  End& operator=(const End& other) {
    arf_set(value_, other.value_);
    is_open = other.is_open;
    return *this;
  }
  ~End() { arf_clear(value_); }
  arf_struct* raw() { return value_; }
  const arf_struct* raw() const { return value_; }
  int sign() const { return arf_sgn(value_); }
  bool is_infinite() const { return arf_is_inf(value_) != 0; }

  bool is_open = false;

 private:
  arf_t value_;
};

/// All real numbers between two ends.
struct Enclosure {
  End lower;
  End upper;

  bool is_positive() const { return lower.sign() > 0 || (lower.sign() == 0 && lower.is_open); }
  bool is_negative() const { return upper.sign() < 0 || (upper.sign() == 0 && upper.is_open); }
  /// 2 positive, 1 not negative, 0 zero, −1, −2 accordingly; nothing if it is not known.
  std::optional<int> sign() const;
};

/// Encloses terms on one box, at a precision in bits.
class Encloser {
 public:
  Encloser(const std::vector<std::string>& names, const std::vector<Side>& box, slong precision);

  /// The sign of a − b for all parameters of the box, from enclosures on it, or on the faces on which a − b is least
  /// and greatest if its derivatives have one sign. Nothing if it is not seen, or a or b may lack a value.
  std::optional<int> sign_of_difference(const NodePointer& a, const NodePointer& b);
  /// Whether a term certainly has a value.
  bool has_value(const NodePointer& term) { return value(*term).has_value(); }

 private:
  using Value = std::optional<Enclosure>;
  struct Jet {
    Value value;
    Value slope;  ///< the derivative by one parameter
  };
  Value value(const Node& term);
  Jet jet(const Node& term, std::size_t parameter);
  Value apply(const std::string& head, const std::vector<Enclosure>& parts, const Node& term) const;
  std::optional<int> direct_sign(const Node& difference);
  Value on_face(const Node& difference, const std::vector<int>& slopes, bool least);

  const std::vector<std::string>& names_;
  slong precision_;
  std::vector<Enclosure> parameters_;
  std::map<const Node*, Value> known_;
  std::vector<NodePointer> kept_;  ///< what has been made here and may be known by its address
};

}  // namespace delcert::replay
