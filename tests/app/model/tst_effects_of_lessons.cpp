// Every effect of every lesson has a description, and its step can be shown and run without it.

#include "app/model/session/session.h"
#include "lessons/api/view/view.h"
#include "sim/effects/all_effects.h"
#include "tests/suite.h"

#include <QtTest>

#include <set>

using namespace app;

namespace {

int linksOf(const lessons::View &view)
{
    return static_cast<int>(view.legs.size() + view.sticks.size() + view.chains.size());
}

bool holds(const sim::EffectPtr &effect)
{
    return effect->kind() == sim::EffectKind::spring || effect->kind() == sim::EffectKind::stick;
}

}

class EffectsOfLessonsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(!m_library.lessons.empty()); }

    void everyEffectSaysWhatItIsFor_data() { steps(); }

    void everyEffectSaysWhatItIsFor()
    {
        open();
        for (const sim::EffectPtr &effect : m_session->editor().listedEffects()) {
            const QString purpose = QString::fromStdString(sim::purposeOf(*effect));
            QVERIFY2(purpose.endsWith('.') && purpose.size() > 10 && purpose.size() < 100,
                     effect->id().c_str());
        }
    }

    /// Off, it is in no phase; the picture, its guides and what the step says of the moment do without it. Undone, the
    /// run has the bits that it had.
    void everyEffectCanBeSwitchedOff_data() { steps(); }

    void everyEffectCanBeSwitchedOff()
    {
        open();
        constexpr std::int64_t frames = 3;
        m_session->playback().goTo({frames, 0});
        const sim::State before = m_session->timeline().state();
        for (const sim::EffectPtr &effect : m_session->editor().listedEffects()) {
            const QString id = QString::fromStdString(effect->id());
            m_session->editor().setEffect(id, false);
            if (!m_session->editor().isOff(id))
                continue; // nothing would move: that was said
            const sim::ComposedInterval &interval = *m_session->timeline().track().nextInterval();
            for (const sim::Phase &phase : interval.pipeline.phases) {
                QVERIFY(!phase.effect || phase.effect->id() != effect->id());
                for (const sim::EffectPtr &one : phase.innerEffects)
                    QVERIFY(one->id() != effect->id());
            }
            m_session->playback().goTo({2 * frames, 1});
            const Picture picture = m_session->presentation().picture();
            QCOMPARE(static_cast<int>(picture.view->bodies.size()), picture.state.pointCount());
            m_session->presentation().note();
            m_session->playback().goTo({frames, 0});
            m_session->editor().undo();
            QVERIFY(!m_session->editor().isOff(id));
            QVERIFY2(sim::sameBits(m_session->timeline().state(), before), qPrintable(id));
        }
    }

    void noLinksAreDrawnWithoutTheirEffects_data() { steps(); }

    void noLinksAreDrawnWithoutTheirEffects()
    {
        open();
        std::set<QString> holding;
        for (const sim::EffectPtr &effect : m_session->editor().listedEffects()) {
            if (holds(effect))
                holding.insert(QString::fromStdString(effect->id()));
        }
        const int links = linksOf(*m_session->presentation().picture().view);
        for (const QString &id : holding)
            m_session->editor().setEffect(id, false);
        QVERIFY(links == 0 || !holding.empty());
        QCOMPARE(linksOf(*m_session->presentation().picture().view), 0);
        for (std::size_t i = 0; i < holding.size(); ++i)
            m_session->editor().undo();
        QCOMPARE(linksOf(*m_session->presentation().picture().view), links);
    }

    /// A room or a ground is drawn only with the effect that bodies bounce off.
    void noContactsMeanNoRoomAndNoGround_data() { steps(); }

    void noContactsMeanNoRoomAndNoGround()
    {
        open();
        for (const sim::EffectPtr &effect : m_session->editor().listedEffects()) {
            if (effect->kind() == sim::EffectKind::contact)
                m_session->editor().setEffect(QString::fromStdString(effect->id()), false);
        }
        const std::shared_ptr<const lessons::View> view = m_session->presentation().picture().view;
        QVERIFY(!view->room);
        QVERIFY(!view->ground);
    }

private:
    void steps()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        for (const LessonEntry &lesson : m_library.lessons) {
            for (const lessons::Step &step : lesson.steps)
                QTest::newRow(qPrintable(lesson.id + '/' + step.id)) << lesson.id << step.id;
        }
    }

    void open()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        m_session = std::make_unique<Session>(m_library);
        m_session->openStep(lesson, step);
    }

    LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    std::unique_ptr<Session> m_session;
};

SUITE(tst_effects_of_lessons, EffectsOfLessonsTest)
#include "tst_effects_of_lessons.moc"
