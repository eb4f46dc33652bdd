#pragma once

#include "app/model/course.h"

#include <cstdint>
#include <vector>

namespace app {

/// One time that a foot stands.
struct Stance
{
    std::int64_t from = 0; ///< the first frame that it stands
    std::int64_t to = 0;   ///< the last one
    double slip = 0.0;     ///< px that it came sideways meanwhile, back and forth added up
    friend bool operator==(const Stance &, const Stance &) = default;
};

/// The times that each foot stands, from the samples of a course. As the course grows, only what is new of it is read.
class Stances
{
public:
    /// Reads what has changed since the last time. To be called after each Course::changed().
    void follow(const Course &course, std::size_t feet);

    std::size_t feet() const { return m_feet.size(); }
    /// In order.
    const std::vector<Stance> &of(std::size_t foot) const { return m_feet[foot]; }

private:
    bool goesOn(const Course &course, std::size_t feet) const;
    void add(const Sample &sample, std::int64_t frame);
    void forgetBefore(std::int64_t frame);

    std::vector<std::vector<Stance>> m_feet;
    std::vector<char> m_stood; ///< by foot, in the row that was read last
    std::int64_t m_first = 0;  ///< the frame from which there are samples
    std::int64_t m_next = 0;   ///< the one that is read next
    std::int64_t m_framesPerOutput = 1;
};

}
