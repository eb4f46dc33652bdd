#include <QDir>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// InstructionSet by what they were counted as.
using Counts = QMap<QString, double>;

/// What `text`, a profile, was counted as, and how many instructions.
void addCount(const QString &text, Counts &counts)
{
    static const QRegularExpression name("^desc: Trigger: Client Request: (.*)$",
                                         QRegularExpression::MultilineOption);
    static const QRegularExpression total("^totals: (\\d+)$", QRegularExpression::MultilineOption);
    const auto named = name.match(text), counted = total.match(text);
    if (named.hasMatch() && counted.hasMatch())
        counts[named.captured(1)] = counted.captured(1).toDouble();
}

/// Runs the counting program. Empty when that fails; `why` says how.
Counts countsOf(const QString &scene, const QString &method, QString &why)
{
    const QTemporaryDir folder;
    QProcess valgrind;
    valgrind.setWorkingDirectory(folder.path());
    valgrind.start(VALGRIND, {"--quiet", "--tool=callgrind", "--callgrind-out-file=counts",
                              "--instr-atstart=no", INSTRUCTIONS, scene, method});
    const bool isDone = valgrind.waitForFinished(300'000);
    why = valgrind.errorString() + valgrind.readAllStandardError();
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

/// The counts whose names begin with `beginning`, by the rest of the name.
Counts under(const Counts &counts, const QString &beginning)
{
    Counts found;
    for (auto it = counts.begin(); it != counts.end(); ++it) {
        if (it.key().startsWith(beginning))
            found[it.key().mid(beginning.size())] = it.value();
    }
    return found;
}

bool isWithin(double share, double a, double b)
{
    return std::abs(a - b) <= share * std::abs(b);
}

/// What each effect takes by its phases, their calls included, and what the method's own take ("").
Counts apart(const Counts &counts)
{
    Counts found;
    const Counts phases = under(counts, "phase "), preludes = under(counts, "prelude ");
    for (auto it = phases.begin(); it != phases.end(); ++it) { // "0 effect gravity", "2 rest kick"
        const QString whose = it.key().section(' ', 1, 1) == "effect" ? it.key().section(' ', 2) : QString();
        const double prelude = preludes.contains(it.key()) ? preludes[it.key()] : 0.0;
        found[whose] += it.value() - prelude;
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

/// What effects cost, in instructions: they are the same on every run, whatever else a computer does.
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

    /// Counted once for all tests.
    Counts countsOfRow(QString &why)
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        Counts &known = m_known[scene + ' ' + method];
        if (known.isEmpty())
            known = countsOf(scene, method, why);
        return known;
    }

    QMap<QString, Counts> m_known;

private slots:
    void initTestCase()
    {
        QVERIFY2(!QString(VALGRIND).isEmpty(),
                 "valgrind is missing: install it (Debian: valgrind) and configure the build again.");
    }

    void takingAnEffectOutSavesWhatItTakes_data()
    {
        addRows({"creature in a room", "walkers"},
                {"published", "semi_implicit_euler", "position_verlet", "velocity_verlet", "rk4"});
    }
    void takingAnEffectOutSavesWhatItTakes()
    {
        QString why;
        const Counts counts = countsOfRow(why);
        QVERIFY2(counts.size() > 10, qPrintable(why));
        const double frame = counts["frame"] - counts["nothing"];
        const Counts parts = apart(counts);
        const Counts without = under(counts, "without ");
        double sum = 0.0;
        for (auto it = parts.begin(); it != parts.end(); ++it) {
            sum += it.value();
            if (it.key().isEmpty())
                continue;
            const double saved = counts["frame"] - without[it.key()];
            QVERIFY2(
                isWithin(0.03, saved, it.value()) || std::abs(saved - it.value()) < 0.002 * frame,
                qPrintable(
                    QString("%1 takes %2, without it %3 less").arg(it.key()).arg(it.value()).arg(saved)));
        }
        QVERIFY2(isWithin(0.1, sum, frame), text(parts) + " of " + QByteArray::number(frame));
    }

    void whatIsNotListedTakesNothing_data()
    {
        addRows({"creature in a room", "walkers"}, {"published", "semi_implicit_euler", "rk4"});
    }
    void whatIsNotListedTakesNothing()
    {
        QString why;
        const Counts counts = countsOfRow(why);
        QVERIFY2(counts.size() > 10, qPrintable(why));
        QCOMPARE(counts["with an idle one"], counts["frame"]);
        const Counts without = under(counts, "without "), off = under(counts, "switched off ");
        QVERIFY(without.size() > 3);
        for (auto it = without.begin(); it != without.end(); ++it)
            QVERIFY2(off[it.key()] == it.value(), qPrintable(it.key()));
    }

    /// Methods that compute effects within phases of their own: calling one again takes what one more call in place
    /// does; and all of them with what stays of the frame make up the frame.
    void whatAMethodComputesOnItsWayAddsUp_data()
    {
        addRows({"creature in a room"}, {"dormand_prince", "dop853", "rkn86", "backward_euler", "tr_bdf2"});
    }
    void whatAMethodComputesOnItsWayAddsUp()
    {
        QString why;
        const Counts counts = countsOfRow(why);
        QVERIFY2(counts.size() > 10, qPrintable(why));
        const double frame = counts["frame"] - counts["nothing"];
        const double rest = frame - (counts["twice"] - counts["once"]);
        double sum = rest;
        const Counts again = under(counts, "again "), more = under(counts, "again and again ");
        for (auto it = more.begin(); it != more.end(); ++it) {
            const double own = it.value() - again[it.key()];
            const double inPlace = counts["twice " + it.key()] - counts["once"];
            sum += own;
            QVERIFY2(isWithin(0.1, own, inPlace) || std::abs(own - inPlace) < 0.01 * frame,
                     qPrintable(QString("%1 takes %2, in place %3").arg(it.key()).arg(own).arg(inPlace)));
        }
        QVERIFY2(isWithin(0.1, sum, frame),
                 qPrintable(QString("%1 of %2, rest %3").arg(sum).arg(frame).arg(rest)));
    }
};

QTEST_GUILESS_MAIN(TestInstructions)
#include "tst_instructions.moc"
