#include "app/model/text/json_writer.h"
#include "tests/suite.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <limits>

using app::JsonWriter;

class JsonWriterTest : public QObject
{
    Q_OBJECT

private slots:
    void objectsKeepTheOrderOfTheirFields()
    {
        JsonWriter json(4);
        json.beginObject();
        json.field("b", 1);
        json.field("a", "text");
        json.field("none", std::optional<double>());
        json.endObject();
        QCOMPARE(json.text(), QByteArray("{\n    \"b\": 1,\n    \"a\": \"text\",\n    \"none\": null\n}"));
    }

    void aListCanHaveItsEntriesOnOneLine()
    {
        JsonWriter json(1);
        json.beginObject();
        json.beginList("ids", JsonWriter::Layout::oneLine);
        json.value("a");
        json.value("b");
        json.endList();
        json.beginList("bodies");
        for (const double x : {0.5, 2.0}) {
            json.beginObject(JsonWriter::Layout::oneLine);
            json.field("x", x);
            json.field("fixed", false);
            json.endObject();
        }
        json.endList();
        json.endObject();
        QCOMPARE(json.text(), QByteArray("{\n \"ids\": [\"a\", \"b\"],\n \"bodies\": [\n"
                                         "  { \"x\": 0.5, \"fixed\": false },\n"
                                         "  { \"x\": 2, \"fixed\": false }\n ]\n}"));
    }

    void emptyObjectsAndListsHaveNoSpace()
    {
        JsonWriter json(1);
        json.beginList();
        json.beginObject();
        json.endObject();
        json.beginList(JsonWriter::Layout::oneLine);
        json.endList();
        json.endList();
        QCOMPARE(json.text(), QByteArray("[\n {},\n []\n]"));
    }

    void anyTextIsReadBack_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("quotation marks") << "say \"no\" \\ \"yes\"";
        QTest::newRow("line breaks") << "one\ntwo\r\n\tthree";
        QTest::newRow("control characters") << QString("\x01\x1b\x7f") + QChar(0x2028);
        QTest::newRow("zero") << QString(QChar(0));
        QTest::newRow("beyond Latin") << "Zürich, 北京, 🙂";
    }
    void anyTextIsReadBack()
    {
        QFETCH(QString, text);
        JsonWriter json(1);
        json.beginObject(JsonWriter::Layout::oneLine);
        json.field(text, text);
        json.endObject();
        QVERIFY(!json.text().contains('\n'));
        const QJsonObject object = QJsonDocument::fromJson(json.text()).object();
        QCOMPARE(object.keys(), QStringList(text));
        QCOMPARE(object[text].toString(), text);
    }

    void anyFiniteNumberIsReadBackExactly_data()
    {
        QTest::addColumn<double>("number");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("whole") << 1.0 << QByteArray("1");
        QTest::newRow("sum") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
        QTest::newRow("large") << 1e100 << QByteArray("1e100");
        QTest::newRow("small") << 1e-7 << QByteArray("1e-7");
        QTest::newRow("negative zero") << -0.0 << QByteArray("-0.0");
        QTest::newRow("largest") << std::numeric_limits<double>::max()
                                 << QByteArray("1.7976931348623157e308");
    }
    void anyFiniteNumberIsReadBackExactly()
    {
        QFETCH(double, number);
        JsonWriter json(1);
        json.value(number);
        QTEST(json.text(), "text");
        QCOMPARE(json.text().toDouble(), number);
        QCOMPARE(std::signbit(json.text().toDouble()), std::signbit(number));
        QVERIFY(json.isFinite());
    }

    void aNumberThatIsNotFiniteBecomesNull()
    {
        for (const double number :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            JsonWriter json(1);
            json.value(number);
            QCOMPARE(json.text(), QByteArray("null"));
            QVERIFY(!json.isFinite());
        }
    }
};

SUITE(tst_json_writer, JsonWriterTest)
#include "tst_json_writer.moc"
