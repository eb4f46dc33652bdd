#include "tests/app/support/session_fixture.h"

#include <QApplication>
#include <QTest>

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

void SessionFixture::goTo(std::int64_t frame)
{
    session.playback().goTo({frame, 0});
    QVERIFY(arrives());
}

bool SessionFixture::arrives() const
{
    return QTest::qWaitFor([this] { return !session.playback().goal(); }, 20'000);
}

}
