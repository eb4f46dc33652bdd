#include "app/model/experiment/blueprint_writer.h"

#include "app/model/text/json_writer.h"

namespace app {

namespace {

using Layout = JsonWriter::Layout;

/// A writer of the scene's parts. Each part is an object on one line.
class PartWriter
{
public:
    PartWriter(const sim::Blueprint &plan, JsonWriter &json) : m_plan(plan), m_json(json) {}

    void write(const sim::BlueprintPoint &one)
    {
        const sim::BlueprintPoint usual;
        m_json.beginObject(QString::fromStdString(one.name), Layout::oneLine);
        m_json.field("x", one.x.x);
        m_json.field("y", one.x.y);
        unlessUsual("vx", one.v.x, usual.v.x);
        unlessUsual("vy", one.v.y, usual.v.y);
        unlessUsual("mass", one.mass, usual.mass);
        unlessUsual("size", one.size, usual.size);
        unlessUsual("fixed", one.fixed, usual.fixed);
        for (const auto &[id, value] : one.properties)
            m_json.field(QString::fromStdString(id), value);
        m_json.endObject();
    }
    void write(const sim::BlueprintSpring &one)
    {
        m_json.beginObject(Layout::oneLine);
        writeEnds(one.a, one.b);
        m_json.field("k", one.k);
        m_json.field("length", one.length);
        m_json.endObject();
    }
    void write(const sim::BlueprintStick &one)
    {
        m_json.beginObject(Layout::oneLine);
        writeEnds(one.a, one.b);
        m_json.field("length", one.length);
        unlessUsual("share", one.share, sim::BlueprintStick().share);
        m_json.endObject();
    }
    void write(const sim::BlueprintGait &one)
    {
        const sim::BlueprintGait usual;
        m_json.beginObject(Layout::oneLine);
        m_json.field("k", one.k);
        m_json.field("leg", one.leg);
        m_json.field("drop", one.drop);
        unlessUsual("speed", one.speed, usual.speed);
        unlessUsual("start", one.start, usual.start);
        unlessUsual("pulls_body", one.pullsBody, usual.pullsBody);
        m_json.endObject();
    }
    void write(const sim::BlueprintFoot &one)
    {
        const sim::BlueprintFoot usual;
        m_json.beginObject(Layout::oneLine);
        m_json.field("foot", nameOf(one.foot));
        m_json.field("body", nameOf(one.body));
        unlessUsual("angle", one.angle, usual.angle);
        unlessUsual("gait", one.gait, usual.gait);
        m_json.endObject();
    }
    void write(const sim::BlueprintRuleLink &one)
    {
        m_json.beginObject(Layout::oneLine);
        writeEnds(one.a, one.b);
        m_json.endObject();
    }
    template <class Part>
    void writeList(const char *name, const std::vector<Part> &parts)
    {
        if (parts.empty())
            return;
        m_json.beginList(name);
        for (const Part &part : parts)
            write(part);
        m_json.endList();
    }

private:
    template <class Value>
    void unlessUsual(const char *name, Value value, Value usual)
    {
        if (value != usual)
            m_json.field(name, value);
    }
    void writeEnds(int a, int b)
    {
        m_json.field("a", nameOf(a));
        m_json.field("b", nameOf(b));
    }
    const std::string &nameOf(int point) const { return m_plan.points[static_cast<std::size_t>(point)].name; }

    const sim::Blueprint &m_plan;
    JsonWriter &m_json;
};

}

void writeBlueprint(const sim::Blueprint &plan, JsonWriter &json)
{
    PartWriter parts(plan, json);
    json.beginObject();
    json.beginObject("bodies");
    for (const sim::BlueprintPoint &one : plan.points)
        parts.write(one);
    json.endObject();
    parts.writeList("springs", plan.springs);
    parts.writeList("sticks", plan.sticks);
    parts.writeList("gaits", plan.gaits);
    parts.writeList("feet", plan.feet);
    json.list("effects", plan.effects, Layout::oneLine);
    if (plan.rule)
        json.field("rule", plan.rule.text());
    parts.writeList("rule_links", plan.ruleLinks);
    json.endObject();
}

}
