#include "app/ui/map/map_page.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step_button.h"
#include "app/ui/map/concept_button.h"
#include "app/ui/map/concept_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int mapMargin = 20;
constexpr int aroundPage = 24;  ///< px of the window that stay visible on each side
constexpr int textHeight = 62;  ///< px: three lines
constexpr int footWidth = 250;  ///< px, of the buttons
constexpr int legendWidth = 34; ///< px, of a sample

/// A small box as in the map, for the legend.
class ConceptSample : public QWidget
{
public:
    ConceptSample(ConceptState state, const Theme &theme, QWidget *parent)
        : QWidget(parent), m_state(state), m_theme(theme)
    {
        setFixedSize(legendWidth, 20);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        paintConcept(painter, rect(), {}, m_state, 1.0, m_theme);
    }

private:
    ConceptState m_state;
    const Theme &m_theme;
};

QString titlesOf(const std::vector<std::size_t> &indices, const std::vector<ConceptNode> &nodes)
{
    QStringList titles;
    for (const std::size_t index : indices)
        titles << nodes[index].title;
    return titles.join(QStringLiteral(", "));
}

}

MapPage::MapPage(Session &session, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_session(session), m_theme(theme), m_count(new QLabel(this)),
      m_view(new ConceptView(theme))
{
    setWindowTitle(tr("Map of concepts"));
    styleAsPanel(*this);
    setModal(false);
    auto *title = new QLabel(tr("What rests on what"), this);
    title->setObjectName("stepTitle");
    m_count->setObjectName("caption");
    auto *titles = new QVBoxLayout;
    titles->setSpacing(2);
    titles->addWidget(title);
    titles->addWidget(m_count);
    auto *head = new QHBoxLayout;
    head->addLayout(titles, 1);
    head->addWidget(makeLegend(), 0, Qt::AlignBottom);
    auto *area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    styleAsPanel(*m_view);
    area->setWidget(m_view);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(mapMargin, 16, mapMargin, 16);
    column->setSpacing(12);
    column->addLayout(head);
    column->addWidget(area, 1);
    makeFoot();
    connect(m_view, &ConceptView::chosen, this, &MapPage::openStep);
    connect(m_view, &ConceptView::litChanged, this, &MapPage::describe);
    connect(&session.progress(), &Progress::changed, this, &MapPage::refresh);
    session.onChange(ChangeKind::texts, this, &MapPage::rebuild);
    rebuild();
}

bool MapPage::hasConcepts(const LessonLibrary &library)
{
    for (std::size_t i = 0; i < library.entries(); ++i) {
        const std::vector<lessons::Step> &steps = library.entry(i).steps;
        if (std::any_of(steps.begin(), steps.end(),
                        [](const lessons::Step &step) { return !step.explanation.concepts.empty(); }))
            return true;
    }
    return false;
}

QWidget *MapPage::makeLegend()
{
    auto *legend = new QWidget(this);
    QHBoxLayout *row = makeRow(legend, 6);
    const std::pair<ConceptState, QString> entries[] = {{ConceptState::known, tr("You know it")},
                                                        {ConceptState::next, tr("Can come next")},
                                                        {ConceptState::later, tr("For later")}};
    for (const auto &[state, name] : entries) {
        auto *label = new QLabel(name, legend);
        label->setObjectName("caption");
        row->addSpacing(10);
        row->addWidget(new ConceptSample(state, m_theme, legend));
        row->addWidget(label);
    }
    return legend;
}

void MapPage::makeFoot()
{
    m_text = new NarrationText(m_theme, this, NarrationText::Kind::aside);
    m_text->setObjectName("conceptText");
    m_text->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_text->setFixedHeight(textHeight); // so that the map does not move
    m_next = new StepButton(this);
    m_next->setObjectName("nextConcept");
    m_next->showArrow(m_theme);
    m_next->setPrimary(true);
    m_next->setFixedWidth(footWidth);
    auto *close = new QPushButton(tr("Close"), this);
    close->setObjectName("closeMap");
    close->setAutoDefault(false);
    close->setFocusPolicy(Qt::TabFocus);
    close->setToolTip(tr("Back to the open step (Esc)"));
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_text, 1);
    row->addWidget(close, 0, Qt::AlignBottom);
    row->addWidget(m_next, 0, Qt::AlignBottom);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_nextNode)
            openStep(*m_nextNode);
    });
}

void MapPage::showMap()
{
    refresh();
    if (parentWidget() && !isVisible())
        setGeometry(
            parentWidget()->window()->geometry().adjusted(aroundPage, aroundPage, -aroundPage, -aroundPage));
    show();
    raise();
    activateWindow();
    if (m_nextNode)
        m_view->button(*m_nextNode).setFocus(Qt::ActiveWindowFocusReason);
}

void MapPage::rebuild()
{
    m_view->setMap(ConceptMap(m_session.library()));
    refresh();
}

void MapPage::refresh()
{
    const ConceptMap map(m_session.library());
    if (map.nodes().size() != m_view->nodes().size()) // a lesson is just being replaced
        m_view->setMap(map);
    const std::vector<ConceptState> states = map.states([this](const QString &lesson, const QString &step) {
        const LessonEntry *entry = m_session.library().lesson(lesson);
        return entry && m_session.isStepDone(*entry, *entry->step(step));
    });
    m_view->setStates(states);
    const auto known = std::count(states.begin(), states.end(), ConceptState::known);
    m_count->setText(tr("You know %1 of %2 concepts. Lines lead up from a concept to those that it rests on.")
                         .arg(known)
                         .arg(states.size()));
    const auto next = std::find(states.begin(), states.end(), ConceptState::next);
    m_nextNode = next == states.end()
                     ? std::nullopt
                     : std::optional<std::size_t>(static_cast<std::size_t>(next - states.begin()));
    m_next->setVisible(m_nextNode.has_value());
    if (m_nextNode) {
        const ConceptNode &node = m_view->nodes()[*m_nextNode];
        m_next->setFullText(known > 0 ? tr("Go on: %1").arg(node.title) : tr("Begin: %1").arg(node.title),
                            node.title);
        m_next->setToolTip(tr("Opens %1").arg(node.where));
    }
    describe();
}

QString MapPage::stateOf(std::size_t node) const
{
    switch (m_view->button(node).state()) {
    case ConceptState::known:
        return tr("you know it");
    case ConceptState::next:
        return tr("it can come next");
    case ConceptState::later:
        break;
    }
    return tr("for later");
}

void MapPage::describe()
{
    const std::optional<std::size_t> lit = m_view->lit();
    if (!lit) {
        m_text->setText(
            tr("Point at a concept to see what it rests on. A click, or **Enter**, opens its step. The "
               "arrow keys go from one to the next."));
        return;
    }
    const ConceptNode &node = m_view->nodes()[*lit];
    QStringList joined;
    if (!node.restsOn.empty())
        joined << tr("Rests on: %1.").arg(titlesOf(node.restsOn, m_view->nodes()));
    if (!node.carries.empty())
        joined << tr("Leads to: %1.").arg(titlesOf(node.carries, m_view->nodes()));
    m_text->setText(QStringLiteral("**%1.** %2 %3 (%4, %5)")
                        .arg(node.title, node.text, joined.join(' '), node.where, stateOf(*lit)));
}

void MapPage::openStep(std::size_t node)
{
    const ConceptNode chosen = m_view->nodes()[node];
    accept();
    m_session.openStep(chosen.lesson, chosen.step);
}

}
