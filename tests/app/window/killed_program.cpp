// The window with random user input (drags, parameters, steps, undo) until the test kills the program.
//   killed_program FOLDER SEED
// Autosaves to FOLDER/scenes and writes a line to FOLDER/log for every state of the open run:
//   milliseconds lesson.step digest-of-the-experiment     ("-" in place of the digest: nothing to save)
// The milliseconds count the user's pauses only. The time that the window takes to respond is not input, and depends on
// the machine.

#include "tests/app/support/window_fixture.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QRandomGenerator>
#include <QSettings>
#include <QTimer>

using namespace app;
using namespace tests;

namespace {

class RandomUser
{
public:
    RandomUser(const QString &folder, quint32 seed) : m_log(folder + "/log"), m_random(seed)
    {
        m_fixture.window.autosaveIn(folder + "/scenes");
        if (!m_log.open(QFile::WriteOnly | QFile::Unbuffered)) // so that every line survives the kill
            qFatal("no log");
        QObject::connect(&m_timer, &QTimer::timeout, &m_fixture.window, [this] { act(); });
        note();
        next();
    }

private:
    void next()
    {
        const int pause = m_random.bounded(1, 90);
        m_waited += pause;
        m_timer.start(pause);
    }

    void act()
    {
        QWidget *picture = m_fixture.view.viewport();
        const QPoint there(m_random.bounded(60, picture->width() - 60),
                           m_random.bounded(60, picture->height() - 60));
        switch (m_random.bounded(12)) {
        case 0:
        case 1:
            QTest::mousePress(picture, Qt::LeftButton, {}, onAnyBody(there));
            break;
        case 2:
        case 3:
        case 4:
            moveMouse(*picture, there, Qt::LeftButton);
            break;
        case 5:
            QTest::mouseRelease(picture, Qt::LeftButton, {}, there);
            break;
        case 6:
            changeParameter();
            break;
        case 7:
            press(Qt::Key_Right, {});
            break;
        case 8:
            press(Qt::Key_Z,
                  m_random.bounded(2) ? Qt::ControlModifier : Qt::ControlModifier | Qt::ShiftModifier);
            break;
        case 9:
            if (m_random.bounded(4) == 0)
                press(m_random.bounded(2) ? Qt::Key_PageDown : Qt::Key_PageUp, {});
            break;
        default:
            press(Qt::Key_Space, {});
        }
        note();
        next();
    }

    /// Without processing events, unlike WindowFixture::key(): the timer of this class is one of them.
    void press(int key, Qt::KeyboardModifiers modifiers)
    {
        QTest::keyClick(&m_fixture.view, Qt::Key(key), modifiers);
    }

    /// Returns the place of a body, or that of the pointer if the body has flown out of the picture.
    QPoint onAnyBody(QPoint pointer)
    {
        const Picture picture = m_fixture.session.presentation().picture();
        const sim::Vec2 at = picture.state.positionOf(m_random.bounded(picture.state.pointCount()));
        const QPoint body = m_fixture.view.mapFromScene(at.x, at.y);
        return m_fixture.view.viewport()->rect().contains(body) ? body : pointer;
    }

    void changeParameter()
    {
        const std::vector<lessons::Parameter> &all = m_fixture.session.step().parameters;
        if (all.empty())
            return;
        const lessons::Parameter &one = all[m_random.bounded(quint32(all.size()))];
        m_fixture.session.editor().setParameter(one.id,
                                                one.min + (one.max - one.min) * m_random.bounded(1.0));
    }

    /// Returns "-" if there is nothing to save.
    QByteArray digestOf(Experiment experiment) const
    {
        experiment.frames = 1; // how far it was computed is no input
        Experiment untouched = newExperiment(experiment.lesson, experiment.step, m_fixture.library);
        untouched.frames = 1;
        const QByteArray text = experimentText(experiment, m_fixture.library);
        if (text == experimentText(untouched, m_fixture.library))
            return "-";
        return QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex();
    }

    void write(const Experiment &experiment)
    {
        const QByteArray state =
            (experiment.lesson + '.' + experiment.step).toUtf8() + ' ' + digestOf(experiment);
        if (state != m_noted)
            m_log.write(QByteArray::number(m_waited) + ' ' + state + '\n');
        m_noted = state;
    }

    void note()
    {
        const Experiment now = m_fixture.session.experiment();
        // Leaving a step has released the body that was held.
        if (m_open && m_open->step != now.step)
            write(*m_fixture.session.experimentOf(m_open->lesson, m_open->step));
        write(now);
        m_open = now;
    }

    WindowFixture m_fixture{{"multi_foot", "any_number"}};
    QFile m_log;
    QRandomGenerator m_random;
    QTimer m_timer;
    int m_waited = 0; ///< ms, with the pause that has begun
    QByteArray m_noted;
    std::optional<Experiment> m_open; ///< the run as it was last noted
};

}

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() != 3)
        qFatal("killed_program FOLDER SEED");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, arguments[1] + "/settings");
    const RandomUser user(arguments[1], arguments[2].toUInt());
    return QApplication::exec();
}
