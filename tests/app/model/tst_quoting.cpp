// Names in messages never break the line, control a terminal, or fill pages.

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;

class WordsTest : public QObject
{
    Q_OBJECT

private slots:
    void invisibleCharactersAreEscaped_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char *name, const QString &text, const char *shown) {
            QTest::newRow(name) << text << QString::fromUtf8(shown);
        };
        row("letters", QString::fromUtf8("Käfer 3 – “x”…"), "Käfer 3 – “x”…");
        row("an emoji", QString::fromUtf8("🐛"), "🐛");
        row("lines", "a\nb\r\tc", "a\\nb\\r\\tc");
        row("a line separator", QString("a%1b%2").arg(QChar(0x2028), QChar(0x2029)), "a\\u2028b\\u2029");
        row("a terminal's escape", "\x1b[2J\x07", "\\u001b[2J\\u0007");
        row("an 8-bit escape", QString(QChar(0x9b)) + "2J", "\\u009b2J");
        row("letters turned round", QString(QChar(0x202e)) + "gpj", "\\u202egpj");
        row("half a letter", QString("a") + QChar(0xd83d) + "b", "a\\ud83db");
        row("a letter that there is not", QString(QChar(0xffff)), "\\uffff");
        row("a tag", QString::fromUcs4(U"\U000E0041", 1), "\\udb40\\udc41");
        row("zero", QString(QChar(0)), "\\u0000");
    }
    void invisibleCharactersAreEscaped()
    {
        QFETCH(QString, text);
        QFETCH(QString, shown);
        QCOMPARE(escaped(text), shown);
        QCOMPARE(escaped(shown), shown);
        QCOMPARE(quoted(text), '"' + shown + '"');
        QCOMPARE(shownPath(text), shown);
        QCOMPARE(UserError("No " + text + ".").sentence(), "No " + shown + ".");
    }

    void aLongNameIsCut()
    {
        QCOMPARE(quoted(QString(40, 'a')), '"' + QString(40, 'a') + '"');
        QCOMPARE(quoted(QString(41, 'a')), '"' + QString(40, 'a') + QChar(0x2026) + '"');
        // The cut is never within an escape sequence or a letter.
        QCOMPARE(quoted(QString(38, 'a') + "\x1b[0m"), '"' + QString(38, 'a') + QChar(0x2026) + '"');
        QCOMPARE(quoted(QString(39, 'a') + QString::fromUtf8("🐛🐛")),
                 '"' + QString(39, 'a') + QChar(0x2026) + '"');
    }

    void aLongPathIsShortenedInTheMiddle()
    {
        const QString path = "/home/" + QString(10'000, 'x') + "/walk.json";
        const QString shown = shownPath(path);
        QCOMPARE(shown.size(), 201);
        QVERIFY(shown.startsWith("/home/xxx") && shown.endsWith("xxx/walk.json"));
        QCOMPARE(shown.count(QChar(0x2026)), 1);
        QCOMPARE(shownPath(QString(200, 'x')), QString(200, 'x'));
        const QString escaped = shownPath(QString(10'000, QChar(0x2028)));
        QVERIFY(escaped.size() > 100 && escaped.size() <= 201);
    }

    void aLongListIsCutToTheNearest()
    {
        const QStringList few = {"left", "right"};
        QCOMPARE(quotedList(few, "rihgt"), "\"left\", \"right\"");
        QStringList many;
        for (int i = 0; i < 1000; ++i)
            many << QString("body%1").arg(i);
        many << "stiff_cloth";
        QCOMPARE(quotedList(many, "stif_clth"),
                 "\"stiff_cloth\", \"body0\", \"body1\", \"body2\", \"body3\" and 996 more");
        QVERIFY(quotedList(many, "Body77").startsWith("\"body77\", "));
        // Some of all of them where nothing was given.
        QCOMPARE(quotedList(many), "\"body0\", \"body1\", \"body2\", \"body3\", \"body4\" and 996 more");
        const QString list = quotedList(QStringList(3, QString(10'000, 'x')), QString(100'000, 'y'));
        QVERIFY(list.contains("xxx") && list.size() < 200);
    }

    void aReportOfOthersIsOneLineWithoutAFullStop()
    {
        QCOMPARE(oneLine(" It failed:\n \x1b[1mbadly.. "), "It failed: \\u001b[1mbadly");
    }
};

SUITE(tst_quoting, WordsTest)
#include "tst_quoting.moc"
