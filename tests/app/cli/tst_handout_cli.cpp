// `springstep handout`, as a shell starts it.

#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace program;

class HandoutCliTest : public QObject
{
    Q_OBJECT

private slots:
    void aLessonBecomesAPdf_data();
    void aLessonBecomesAPdf();
    void badUseIsOneSentenceAndCodeTwo_data();
    void badUseIsOneSentenceAndCodeTwo();
};

void HandoutCliTest::aLessonBecomesAPdf_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("language");
    QTest::addColumn<QByteArray>("title"); ///< in UTF-16, as PDF has it
    const auto utf16 = [](const QString &text) {
        QByteArray bytes;
        for (const QChar one : text)
            bytes.append(static_cast<char>(one.row())).append(static_cast<char>(one.cell()));
        return bytes;
    };
    QTest::newRow("in English") << "two_body"
                                << "en" << utf16("Two bodies");
    QTest::newRow("in German") << "two_body"
                               << "de" << utf16("Zwei");
}

void HandoutCliTest::aLessonBecomesAPdf()
{
    QFETCH(QString, lesson);
    QFETCH(QString, language);
    QFETCH(QByteArray, title);
    QTemporaryDir folder;
    const QString out = folder.filePath("lesson.pdf");
    const Answer answer = springstep({"handout", lesson, out, "--language", language});
    QCOMPARE(answer.out + answer.err, QString());
    QCOMPARE(answer.code, 0);
    QFile file(out);
    QVERIFY(file.open(QFile::ReadOnly));
    const QByteArray pdf = file.readAll();
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.contains(title));
}

void HandoutCliTest::badUseIsOneSentenceAndCodeTwo_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("another ending") << QStringList{"two_body", "out.txt"}
                                    << "\"out.txt\" is not the name of a handout; it ends in .pdf.";
    QTest::newRow("another language") << QStringList{"two_body", "out.pdf", "--language", "xx"}
                                      << "--language is \"xx\"; it can be de, en, es, fr.";
    QTest::newRow("no such lesson") << QStringList{"two_bodies", "out.pdf", "--language", "en"}
                                    << "handout: there is no lesson \"two_bodies\"";
    QTest::newRow("a file that is no lesson")
        << QStringList{SOURCE_DIR "/README.md", "out.pdf", "--language", "en"}
        << "README.md: this is not a zip, or its end is missing. Choose the lesson.json or the zip of a "
           "lesson";
    QTest::newRow("no such folder") << QStringList{"two_body", "/nowhere/out.pdf", "--language", "en"}
                                    << "the file could not be written";
}

void HandoutCliTest::badUseIsOneSentenceAndCodeTwo()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, sentence);
    const Answer answer = springstep(QStringList{"handout"} + arguments);
    QVERIFY2(answer.err.contains(sentence), qPrintable(answer.err));
    checkRefusal(answer);
}

SUITE(tst_handout_cli, HandoutCliTest)
#include "tst_handout_cli.moc"
