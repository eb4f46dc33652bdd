// Every effect of every step of every lesson: what it is for, and that the step can be seen and run without it.

#include "app/model/session.h"
#include "lessons/api/view/view.h"
#include "sim/effects/all_effects.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include <set>

using namespace app;

namespace {

int linksOf(const lessons::View &look)
{
    return static_cast<int>(look.legs.size() + look.sticks.size() + look.chains.size());
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
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        QVERIFY(!m_library.lessons.empty());
    }

    void everyEffectSaysWhatItIsFor_data() { steps(); }

    void everyEffectSaysWhatItIsFor()
    {
        open();
        for (const sim::EffectPtr &effect : m_session->listedEffects()) {
            const QString purpose = QString::fromStdString(sim::purposeOf(*effect));
            QVERIFY2(purpose.endsWith('.') && purpose.size() < 100, effect->id().c_str());
        }
    }

    /// Off, it is in no phase; the picture, its guides and what the step says of the moment do without it. Undone, the
    /// run has the bits that it had.
    void everyEffectCanBeSwitchedOff_data() { steps(); }

    void everyEffectCanBeSwitchedOff()
    {
        open();
        constexpr std::int64_t frames = 3;
        m_session->goTo({frames, 0});
        const sim::State before = m_session->timeline().state();
        for (const sim::EffectPtr &effect : m_session->listedEffects()) {
            const QString id = QString::fromStdString(effect->id());
            m_session->setEffect(id, false);
            if (!m_session->isOff(id))
                continue; // nothing would move: that was said
            const sim::ComposedInterval &interval = *m_session->timeline().track().nextInterval();
            for (const sim::Phase &phase : interval.pipeline.phases) {
                QVERIFY(!phase.effect || phase.effect->id() != effect->id());
                for (const sim::EffectPtr &one : phase.innerEffects)
                    QVERIFY(one->id() != effect->id());
            }
            m_session->goTo({2 * frames, 1});
            const Picture picture = m_session->picture();
            QCOMPARE(static_cast<int>(picture.look->bodies.size()), picture.state.pointCount());
            m_session->note();
            m_session->goTo({frames, 0});
            m_session->undo();
            QVERIFY(!m_session->isOff(id));
            QVERIFY2(sim::sameBits(m_session->timeline().state(), before), qPrintable(id));
        }
    }

    void nothingThatHoldsMeansNoLinks_data() { steps(); }

    void nothingThatHoldsMeansNoLinks()
    {
        open();
        std::set<QString> holding;
        for (const sim::EffectPtr &effect : m_session->listedEffects()) {
            if (holds(effect))
                holding.insert(QString::fromStdString(effect->id()));
        }
        if (holding.empty())
            QSKIP("nothing holds here");
        const int links = linksOf(*m_session->picture().look);
        for (const QString &id : holding)
            m_session->setEffect(id, false);
        QCOMPARE(linksOf(*m_session->picture().look), 0);
        for (std::size_t i = 0; i < holding.size(); ++i)
            m_session->undo();
        QCOMPARE(linksOf(*m_session->picture().look), links);
    }

    /// Whatever bounces is drawn by the effect that it bounces off.
    void noContactsMeanNoRoomAndNoGround_data() { steps(); }

    void noContactsMeanNoRoomAndNoGround()
    {
        open();
        bool any = false;
        for (const sim::EffectPtr &effect : m_session->listedEffects()) {
            if (effect->kind() != sim::EffectKind::contact)
                continue;
            m_session->setEffect(QString::fromStdString(effect->id()), false);
            any = true;
        }
        const std::shared_ptr<const lessons::View> look = m_session->picture().look;
        if (!any)
            QSKIP("nothing to touch here");
        QVERIFY(!look->room);
        QVERIFY(!look->ground);
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

    QTemporaryDir m_folder;
    LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    std::unique_ptr<Session> m_session;
};

QTEST_MAIN(EffectsOfLessonsTest)
#include "tst_effects_of_lessons.moc"
