#include "tests/app/support/session_fixture.h"

#include <QApplication>

using namespace app;

namespace tests {

SessionFixture::SessionFixture(LessonLibrary lessons)
    : SessionFixture(Lessons{nullptr, std::move(lessons)}, Scheme::light)
{
}

SessionFixture::SessionFixture(Lessons lessons, Scheme scheme)
    : language(std::move(lessons.language)), library(std::move(lessons.library)), session(library),
      theme(scheme)
{
    theme.apply(*qApp); // before any widget is made: some ask for the font at once
}

}
