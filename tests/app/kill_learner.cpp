// A learner who never rests, in the real window, until somebody kills the program: drags, numbers, steps, undo, at random.
//   kill_learner FOLDER SEED
// Keeps scenes in FOLDER/scenes and writes a line to FOLDER/log for every state that the open run comes to:
//   milliseconds lesson.step digest-of-the-experiment     ("-" in place of the digest: nothing to save)

#include "window_bench.h"

#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QRandomGenerator>
#include <QTimer>

using namespace app;
using window_bench::Bench;

namespace {

class Learner
{
public:
    Learner(const QString &folder, quint32 seed) : m_log(folder + "/log"), m_random(seed)
    {
        m_bench.window.keepScenesIn(folder + "/scenes");
        if (!m_log.open(QFile::WriteOnly | QFile::Unbuffered)) // what is written outlives the program
            qFatal("no log");
        m_clock.start();
        QObject::connect(&m_timer, &QTimer::timeout, &m_bench.window, [this] { act(); });
        note();
        next();
    }

private:
    void next() { m_timer.start(m_random.bounded(1, 90)); }

    void act()
    {
        QWidget *picture = m_bench.view.viewport();
        const QPoint there(m_random.bounded(60, picture->width() - 60),
                           m_random.bounded(60, picture->height() - 60));
        switch (m_random.bounded(12)) {
        case 0:
        case 1:
            QTest::mousePress(picture, Qt::LeftButton, {}, onBody());
            break;
        case 2:
        case 3:
        case 4: {
            QMouseEvent move(QEvent::MouseMove, there, picture->mapToGlobal(there), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(picture, &move);
            break;
        }
        case 5:
            QTest::mouseRelease(picture, Qt::LeftButton, {}, there);
            break;
        case 6:
            changeNumber();
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

    /// QTest would wait for what comes of a key, and for the next move of this learner with it.
    void press(int key, Qt::KeyboardModifiers modifiers)
    {
        QTest::keyClick(&m_bench.view, Qt::Key(key), modifiers);
    }

    QPoint onBody()
    {
        const Picture picture = m_bench.session.picture();
        const sim::Vec2 at = picture.state.positionOf(m_random.bounded(picture.state.pointCount()));
        return m_bench.view.mapFromScene(at.x, at.y);
    }

    void changeNumber()
    {
        const std::vector<lessons::Parameter> &all = m_bench.session.step().parameters;
        if (all.empty())
            return;
        const lessons::Parameter &one = all[m_random.bounded(quint32(all.size()))];
        m_bench.session.setParameter(one.id, one.min + (one.max - one.min) * m_random.bounded(1.0));
    }

    /// "-" where there is nothing to save.
    QByteArray digestOf(Experiment experiment) const
    {
        experiment.frames = 1; // how far it was computed is no input
        Experiment untouched = newExperiment(experiment.lesson, experiment.step, m_bench.library);
        untouched.frames = 1;
        const QByteArray text = experimentText(experiment, m_bench.library);
        if (text == experimentText(untouched, m_bench.library))
            return "-";
        return QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex();
    }

    void write(const Experiment &experiment)
    {
        const QByteArray state =
            (experiment.lesson + '.' + experiment.step).toUtf8() + ' ' + digestOf(experiment);
        if (state != m_noted)
            m_log.write(QByteArray::number(m_clock.elapsed()) + ' ' + state + '\n');
        m_noted = state;
    }

    void note()
    {
        const Experiment now = m_bench.session.experiment();
        // A step that was left has let go of what was held.
        if (m_open && m_open->step != now.step)
            write(*m_bench.session.left(m_open->lesson, m_open->step));
        write(now);
        m_open = now;
    }

    Bench m_bench{"multi_foot", "any_number"};
    QFile m_log;
    QRandomGenerator m_random;
    QElapsedTimer m_clock;
    QTimer m_timer;
    QByteArray m_noted;
    std::optional<Experiment> m_open; ///< the run as it was last noted
};

}

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() != 3)
        qFatal("kill_learner FOLDER SEED");
    window_bench::keepSettingsIn(arguments[1] + "/settings");
    const Learner learner(arguments[1], arguments[2].toUInt());
    return QApplication::exec();
}
