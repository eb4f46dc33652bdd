#include "tests/suite.h"

#include <QDir>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// Numbers of instructions by the name of the count.
using Counts = QMap<QString, double>;

/// Adds the name and the number of instructions of the callgrind profile `text` to `counts`.
void addCount(const QString &text, Counts &counts)
{
    static const QRegularExpression name("^desc: Trigger: Client Request: (.*)$",
                                         QRegularExpression::MultilineOption);
    static const QRegularExpression total("^totals: (\\d+)$", QRegularExpression::MultilineOption);
    const auto nameMatch = name.match(text), totalMatch = total.match(text);
    if (nameMatch.hasMatch() && totalMatch.hasMatch())
        counts[nameMatch.captured(1)] = totalMatch.captured(1).toDouble();
}

/// Runs the counting program. Returns nothing if it fails, with the reason in `reason`.
Counts countsOf(const QString &scene, const QString &method, QString &reason)
{
    const QTemporaryDir folder;
    QProcess valgrind;
    valgrind.setWorkingDirectory(folder.path());
    valgrind.start(VALGRIND, {"--quiet", "--tool=callgrind", "--callgrind-out-file=counts",
                              "--instr-atstart=no", INSTRUCTIONS, scene, method});
    const bool isDone = valgrind.waitForFinished(300'000);
    reason = valgrind.errorString() + valgrind.readAllStandardError();
    Counts counts;
    if (!isDone || valgrind.exitStatus() != QProcess::NormalExit || valgrind.exitCode() != 0)
        return counts;
    for (const QString &name : QDir(folder.path()).entryList({"counts.*"})) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly))
            addCount(QString::fromUtf8(file.readAll()), counts);
    }
    return counts;
}

/// Returns the counts whose names begin with `prefix`, by the rest of the name.
Counts withPrefix(const Counts &counts, const QString &prefix)
{
    Counts found;
    for (auto it = counts.begin(); it != counts.end(); ++it) {
        if (it.key().startsWith(prefix))
            found[it.key().mid(prefix.size())] = it.value();
    }
    return found;
}

bool isWithin(double share, double a, double b)
{
    return std::abs(a - b) <= share * std::abs(b);
}

/// Returns the instructions of each effect's phases, and those of the method's phases and preludes under "".
Counts countsByEffect(const Counts &counts)
{
    Counts found;
    const Counts phases = withPrefix(counts, "phase "), preludes = withPrefix(counts, "prelude ");
    for (auto it = phases.begin(); it != phases.end(); ++it) { // "0 effect gravity", "2 rest kick"
        const QString effect = it.key().section(' ', 1, 1) == "effect" ? it.key().section(' ', 2) : QString();
        const double prelude = preludes.contains(it.key()) ? preludes[it.key()] : 0.0;
        found[effect] += it.value() - prelude;
        found[{}] += prelude;
    }
    return found;
}

QByteArray text(const Counts &counts)
{
    QStringList lines;
    for (auto it = counts.begin(); it != counts.end(); ++it)
        lines << QString("%1: %2").arg(it.key()).arg(it.value());
    return lines.join(", ").toUtf8();
}

}

/// The cost of effects in instructions, which are the same on every run.
class TestInstructions : public QObject
{
    Q_OBJECT

    static void addRows(const QStringList &scenes, const QStringList &methods)
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        for (const QString &scene : scenes) {
            for (const QString &method : methods)
                QTest::addRow("%s, %s", qPrintable(scene), qPrintable(method)) << scene << method;
        }
    }

    /// Returns the counts of the current row. Each scene and method is counted only once.
    Counts currentCounts(QString &reason)
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        Counts &cached = m_known[scene + ' ' + method];
        if (cached.isEmpty())
            cached = countsOf(scene, method, reason);
        return cached;
    }

    QMap<QString, Counts> m_known;

private slots:
    void initTestCase()
    {
        QVERIFY2(!QString(VALGRIND).isEmpty(),
                 "valgrind is missing: install it (Debian: valgrind) and configure the build again.");
    }

    void removedEffectSavesItsCost_data()
    {
        addRows({"creature in a room", "walkers"},
                {"published", "semi_implicit_euler", "position_verlet", "velocity_verlet", "rk4"});
    }
    void removedEffectSavesItsCost()
    {
        QString reason;
        const Counts counts = currentCounts(reason);
        QVERIFY2(counts.size() > 10, qPrintable(reason));
        const double frame = counts["frame"] - counts["nothing"];
        const Counts byEffect = countsByEffect(counts);
        const Counts without = withPrefix(counts, "without ");
        double sum = 0.0;
        for (auto it = byEffect.begin(); it != byEffect.end(); ++it) {
            sum += it.value();
            if (it.key().isEmpty())
                continue;
            const double saved = counts["frame"] - without[it.key()];
            QVERIFY2(
                isWithin(0.03, saved, it.value()) || std::abs(saved - it.value()) < 0.002 * frame,
                qPrintable(
                    QString("%1 takes %2, without it %3 less").arg(it.key()).arg(it.value()).arg(saved)));
        }
        QVERIFY2(isWithin(0.1, sum, frame), text(byEffect) + " of " + QByteArray::number(frame));
    }

    void idleAndDisabledEffectsCostNothing_data()
    {
        addRows({"creature in a room", "walkers"}, {"published", "semi_implicit_euler", "rk4"});
    }
    void idleAndDisabledEffectsCostNothing()
    {
        QString reason;
        const Counts counts = currentCounts(reason);
        QVERIFY2(counts.size() > 10, qPrintable(reason));
        QCOMPARE(counts["with an idle one"], counts["frame"]);
        const Counts without = withPrefix(counts, "without "), disabled = withPrefix(counts, "switched off ");
        QVERIFY(without.size() > 3);
        for (auto it = without.begin(); it != without.end(); ++it)
            QVERIFY2(disabled[it.key()] == it.value(), qPrintable(it.key()));
    }

    /// For methods that compute several effects within one phase. Repeating a call alone costs as much as
    /// repeating it within the frame. All calls and the rest of the frame add up to the frame.
    void costsWithinAPhaseAddUp_data()
    {
        addRows({"creature in a room"}, {"dormand_prince", "dop853", "rkn86", "backward_euler", "tr_bdf2"});
    }
    void costsWithinAPhaseAddUp()
    {
        QString reason;
        const Counts counts = currentCounts(reason);
        QVERIFY2(counts.size() > 10, qPrintable(reason));
        const double frame = counts["frame"] - counts["nothing"];
        const double rest = frame - (counts["twice"] - counts["once"]);
        double sum = rest;
        const Counts again = withPrefix(counts, "again "), more = withPrefix(counts, "again and again ");
        for (auto it = more.begin(); it != more.end(); ++it) {
            const double extraCall = it.value() - again[it.key()];
            const double inPlace = counts["twice " + it.key()] - counts["once"];
            sum += extraCall;
            QVERIFY2(
                isWithin(0.1, extraCall, inPlace) || std::abs(extraCall - inPlace) < 0.01 * frame,
                qPrintable(QString("%1 takes %2, in place %3").arg(it.key()).arg(extraCall).arg(inPlace)));
        }
        QVERIFY2(isWithin(0.1, sum, frame),
                 qPrintable(QString("%1 of %2, rest %3").arg(sum).arg(frame).arg(rest)));
    }
};

SUITE(tst_instructions, TestInstructions)
#include "tst_instructions.moc"
