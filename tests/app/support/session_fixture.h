#pragma once

#include "app/model/session/session.h"
#include "app/model/text/language.h"
#include "app/ui/theme/theme.h"
#include "tests/app/support/two_lessons.h"

#include <memory>

namespace tests {

/// Lessons, with the language that they were read in; null: English.
struct Lessons
{
    std::unique_ptr<app::Language> language;
    app::LessonLibrary library;
};

/// Lessons, a session that has opened their first step, and the theme, applied to the application: what widgets need.
struct SessionFixture
{
    explicit SessionFixture(app::LessonLibrary lessons = twoLessons());
    SessionFixture(Lessons lessons, app::Scheme scheme);

    /// Goes to the start of a frame and waits until the session is there: distant frames are computed in slices.
    void goTo(std::int64_t frame);
    /// Waits until the session is where it was told to go. Returns whether it came there within 20 s.
    bool arrives() const;

    std::unique_ptr<app::Language> language;
    app::LessonLibrary library;
    app::Session session;
    app::Theme theme;
};

}
