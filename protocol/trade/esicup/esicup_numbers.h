// Decimal numbers of ESICUP XML, without the noise that floating point would add to their sums.
//
// The form's y and angles run the other way round, and its reader and writer both convert them here.  A result has no
// more decimals than the numbers that it is computed from, so a length or an angle that is written reads back as the
// same double, as long as both have at most 15 digits.  Units: those of the numbers; angles are in degrees.
// Errors: none.
#pragma once

namespace selvage::protocol::trade::esicup {

// (1) difference(a, difference(a, b)) == b
[[nodiscard]] double difference(double a, double b);
// The same angle, with y pointing the other way: at least 0 and less than 360.
// (1) reversed_angle(reversed_angle(a)) == a for such an angle
[[nodiscard]] double reversed_angle(double degrees);

}  // namespace selvage::protocol::trade::esicup
