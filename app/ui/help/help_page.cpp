#include "app/ui/help/help_page.h"

#include "app/model/text/phrases.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/help/key_caps.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int columnWidth = 412; ///< px
constexpr int longGesture = 230; ///< px; a longer one is below its text
constexpr int pageMargin = 24;
constexpr int rowHeight = 24;
constexpr int rowGap = 1; ///< px, above and below a text
constexpr int headHeight = 90;

/// Makes a label. `name` is its object name in the style sheet.
QLabel *label(const QString &text, const char *name, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    return label;
}

QString sentence(QString text)
{
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

}

HelpPage::HelpPage(const Theme &theme, QWidget *parent) : QDialog(parent), m_theme(theme), m_page(new QWidget)
{
    setWindowTitle(tr("Keys and mouse"));
    setModal(false);
    m_page->setObjectName("panel");
    m_page->setAttribute(Qt::WA_StyledBackground);
    auto *title = label(tr("Keys and mouse"), "stepTitle", m_page);
    auto *hint =
        label(tr("Everything works without the mouse, too. Esc closes this page."), "caption", m_page);
    m_row = new QHBoxLayout;
    m_row->setSpacing(2 * pageMargin);
    for (QVBoxLayout *&column : m_columns) {
        column = new QVBoxLayout;
        column->setSpacing(14);
        column->addStretch(1); // an alignment would ignore that wrapped texts need more height
        m_row->addLayout(column);
    }
    auto *page = new QVBoxLayout(m_page);
    page->setContentsMargins(pageMargin, 20, pageMargin, pageMargin);
    page->setSpacing(2);
    page->addWidget(title);
    page->addWidget(hint);
    page->addSpacing(16);
    page->addLayout(m_row);
    page->addStretch(1);
    auto *area = m_area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    area->setAccessibleName(windowTitle());
    area->setWidget(m_page);
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(area);
}

void HelpPage::addAction(const QString &group, const QAction *action)
{
    if (action->shortcuts().isEmpty())
        return;
    QString text = action->text();
    text.remove('&').remove(QChar(0x2026));
    addRow(group, text, new KeyCaps(action->shortcuts(), m_theme));
}

void HelpPage::addGesture(const QString &group, const QString &gesture, const QString &effect)
{
    addRow(group, sentence(effect), new KeyCaps(gesture, m_theme));
}

HelpPage::Group &HelpPage::groupCalled(const QString &name)
{
    const auto found = std::find_if(m_groups.begin(), m_groups.end(),
                                    [&](const Group &group) { return group.name == name; });
    if (found != m_groups.end())
        return *found;
    auto *box = new QWidget(m_page);
    auto *column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    QLabel *heading = label(name, "heading", box);
    heading->setMinimumHeight(rowHeight);
    column->addWidget(heading);
    return m_groups.emplace_back(Group{name, box, column, 0});
}

void HelpPage::addRow(const QString &group, const QString &text, QWidget *caps)
{
    Group &to = groupCalled(group);
    ++to.rows;
    static const QRegularExpression beforeUnit(QStringLiteral("(?<=\\d) (?=px)"));
    auto *what = label(QString(text).replace(beforeUnit, QChar(QChar::Nbsp)), "action", to.box);
    what->setWordWrap(true);
    what->setMinimumHeight(rowHeight - 2 * rowGap);
    what->setAccessibleName(labelled(text, caps->accessibleName()));
    // Each row has its own layout: a text beside many keys is narrower than one beside few keys. Beside a long gesture it
    // would be squashed.
    const bool isBelow = caps->sizeHint().width() > longGesture;
    auto *row = new QBoxLayout(isBelow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    row->setContentsMargins(0, rowGap, 0, rowGap);
    row->setSpacing(isBelow ? 0 : 16);
    row->addWidget(what, 1);
    row->addWidget(caps, 0, isBelow ? Qt::AlignRight : Qt::AlignVCenter);
    to.column->addLayout(row);
}

int HelpPage::fill(std::size_t columns)
{
    std::array<int, std::tuple_size_v<decltype(m_columns)>> rows{};
    for (QVBoxLayout *column : m_columns) {
        for (const Group &group : m_groups)
            column->removeWidget(group.box);
    }
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(columns);
    for (const Group &group : m_groups) {
        const auto shortest = std::min_element(rows.begin(), end);
        QVBoxLayout *column = m_columns[static_cast<std::size_t>(shortest - rows.begin())];
        column->insertWidget(column->count() - 1, group.box);
        group.box->setVisible(group.rows > 0);
        *shortest += group.rows > 0 ? group.rows + 2 : 0;
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        m_row->setStretch(static_cast<int>(i), i < columns ? 1 : 0);
    return *std::max_element(rows.begin(), rows.end());
}

void HelpPage::fitTo(QSize screen)
{
    // The lengths of the groups are known only now. A further column is there if the page would scroll without
    // it.
    const QSize most = screen - QSize(80, 80);
    const auto widthOf = [](std::size_t columns) {
        return static_cast<int>(columns) * (columnWidth + 2 * pageMargin);
    };
    std::size_t columns = 2;
    int high = fill(columns) * rowHeight + headHeight;
    while (high > most.height() && columns < m_columns.size() && widthOf(columns + 1) <= most.width())
        high = fill(++columns) * rowHeight + headHeight;
    m_page->setMinimumHeight(0);
    resize(std::min(widthOf(columns), most.width()), std::min(high, most.height()));
}

void HelpPage::resizeEvent(QResizeEvent *event)
{
    QDialog::resizeEvent(event);
    makeRoom();
}

void HelpPage::makeRoom()
{
    // A scroll area does not use the height-for-width of its page, so wrapped texts would be squashed. The
    // height is negative if it does not depend on the width.
    m_page->setMinimumHeight(std::max(0, m_page->layout()->totalHeightForWidth(m_area->viewport()->width())));
}

void HelpPage::setVisible(bool visible)
{
    if (visible && !isVisible()) {
        fitTo(screen()->availableGeometry().size());
        placeOverParent(*this);
    }
    QDialog::setVisible(visible);
    if (!visible)
        return;
    makeRoom(); // the groups had no height while the page was hidden
    // The page got its height when it was shown, but its layout was not notified.
    m_page->layout()->invalidate();
    m_page->layout()->activate();
}

}
