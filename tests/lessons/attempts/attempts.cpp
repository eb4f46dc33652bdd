#include "tests/lessons/attempts/attempts.h"

#include "tests/lesson_list.h"

#include <map>

namespace support {

#define DECLARE(lesson) ATTEMPTS(lesson);
LESSONS(DECLARE)
#undef DECLARE

std::vector<Attempt> attemptsOf(const std::string &lesson)
{
#define ENTRY(lesson) {#lesson, attempts_of_##lesson},
    static const std::map<std::string, std::vector<Attempt> (*)()> all{LESSONS(ENTRY)};
#undef ENTRY
    const auto found = all.find(lesson);
    return found == all.end() ? std::vector<Attempt>() : found->second();
}

}
