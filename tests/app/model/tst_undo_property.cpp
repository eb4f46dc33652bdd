// After random edits of any step, undoing all gives the bits of the start, and redoing all those of the end.

#include "tests/app/model/random_gestures.h"

#include "app/model/run/same_run.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;

namespace {

constexpr int manyPoints = 500;

/// A run's script and one of its states.
struct Found
{
    sim::Script script;
    sim::State state;
};

Found look(Session &session, std::int64_t frame)
{
    session.playback().goTo({frame, 0});
    arrive(session);
    return {session.timeline().script(), session.timeline().state()};
}

/// Returns whether two lists have the same runs with the same names.
bool sameList(const Branches &a, const Branches &b)
{
    return std::equal(a.all().begin(), a.all().end(), b.all().begin(), b.all().end(),
                      [](const Branch &one, const Branch &other) {
                          return one.id == other.id && one.name == other.name && one.isKept == other.isKept &&
                                 sameScript(*one.script, *other.script);
                      });
}

bool isSame(const Found &a, const Found &b)
{
    return sameScript(a.script, b.script) && sim::sameBits(a.state, b.state);
}

}

class UndoPropertyTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        bool isGiven = false;
        m_seed = qEnvironmentVariable("SPRINGSTEP_SEED").toUInt(&isGiven);
        if (!isGiven)
            m_seed = std::random_device{}() % 1'000'000;
        qInfo("SPRINGSTEP_SEED=%u", m_seed);
        m_library = LessonLibrary::load(LessonLibrary::folders());
        QVERIFY(!m_library.lessons.empty());
    }

    void allUndoneIsTheStartAndAllRedoneIsTheEnd_data()
    {
        QTest::addColumn<QString>("lesson");
        for (const LessonEntry &lesson : m_library.lessons)
            QTest::newRow(qPrintable(lesson.id)) << lesson.id;
    }

    void allUndoneIsTheStartAndAllRedoneIsTheEnd()
    {
        QFETCH(QString, lesson);
        Session session(m_library);
        unsigned seed = m_seed;
        m_edits = 0;
        for (const lessons::Step &step : m_library.lesson(lesson)->steps) {
            session.openStep(lesson, step.id);
            const bool isLarge = session.timeline().state().pointCount() > manyPoints;
            tryOut(session, ++seed, isLarge ? 4 : 20, isLarge ? 5 : 14);
        }
        QVERIFY2(m_edits > 0, "nothing was done");
    }

private:
    void tryOut(Session &session, unsigned seed, int frames, int count)
    {
        RandomGestures gestures(session, seed, frames);
        const Found start = look(session, frames);
        for (int i = 0; i < count; ++i)
            gestures.act();
        const Found end = look(session, frames);
        const QByteArray what =
            QStringLiteral("%1, seed %2: %3").arg(session.step().id).arg(seed).arg(gestures.done()).toUtf8();
        const auto straight = [&](const Found &found) {
            sim::Track track(found.script, 0);
            track.seek({frames, 0});
            return sim::sameBits(track.state(), found.state);
        };
        QVERIFY2(straight(end), what);
        while (session.editor().undoStack().canRedo()) // an undo among the gestures leaves some
            session.editor().redo();
        const Found last = look(session, frames);
        const Branches branches = session.comparisons().branches();
        m_edits += session.editor().undoStack().count();
        while (session.editor().undoStack().canUndo())
            session.editor().undo();
        QVERIFY2(isSame(look(session, frames), start), what);
        while (session.editor().undoStack().canRedo())
            session.editor().redo();
        QVERIFY2(isSame(look(session, frames), last), what);
        QVERIFY2(sameList(session.comparisons().branches(), branches), what);
    }

    LessonLibrary m_library;
    unsigned m_seed = 0;
    int m_edits = 0; ///< in all steps of a lesson
};

SUITE(tst_undo_property, UndoPropertyTest)
#include "tst_undo_property.moc"
