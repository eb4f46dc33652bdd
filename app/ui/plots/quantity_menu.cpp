#include "app/ui/plots/quantity_menu.h"

#include "app/model/text/quantity_text.h"
#include "app/model/text/sentences.h"

#include <algorithm>

namespace app {

QuantityMenu::QuantityMenu(const OpenRun &run, Axis axis, std::function<Quantity()> current, QWidget *parent)
    : QMenu(parent), m_run(run), m_axis(axis), m_current(std::move(current))
{
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &QuantityMenu::fill);
}

QAction *QuantityMenu::addChoice(QMenu &menu, const QString &text, const Quantity &quantity, bool isCurrent)
{
    QAction *made = menu.addAction(text);
    made->setCheckable(true);
    made->setChecked(isCurrent);
    connect(made, &QAction::triggered, this, [this, quantity] { emit chosen(quantity); });
    return made;
}

void QuantityMenu::fill()
{
    qDeleteAll(findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly)); // clear() leaves them
    clear();
    const Quantity current = m_current();
    if (m_axis == Axis::across) {
        addChoice(*this, kindTitle(QuantityKind::time), {}, current.what == QuantityKind::time)
            ->setToolTip(kindHelp(QuantityKind::time));
        addSeparator();
    }
    addQuantities(current, About::oneBody);
    addSeparator();
    addDistances(current);
    addQuantities(current, About::run);
    if (aboutOf(current.what) != About::run) {
        addSeparator();
        addBodies(current);
    }
}

void QuantityMenu::addQuantities(const Quantity &current, About about)
{
    const Eigen::ArrayXd &angles = scene().start.angle;
    for (const QuantityKind what : quantityKinds()) {
        const bool isAngle = what == QuantityKind::angle || what == QuantityKind::spin;
        if (aboutOf(what) != about || what == QuantityKind::time ||
            (isAngle && angles.rows() == 0 && what != current.what))
            continue;
        const Quantity quantity{what, about == About::run ? QString() : current.body};
        QAction *made = addChoice(*this, kindTitle(what), quantity, what == current.what);
        made->setToolTip(kindHelp(what));
        const Quantity bound = boundTo(quantity, m_run.selected());
        if (const std::optional<NoValue> why = whyNot(bound, scene())) {
            made->setEnabled(*why == NoValue::noSuchBody); // the body can still be changed
            made->setToolTip(noValueWords(bound, scene(), *why));
        }
    }
}

void QuantityMenu::addRest(QMenu &menu, int count)
{
    if (count <= 0)
        return;
    QAction *rest = menu.addAction(tr("… and %1 more").arg(count));
    rest->setEnabled(false);
    rest->setToolTip(tr("Select one in the picture, then pin the plot to it"));
}

void QuantityMenu::addDistances(const Quantity &current)
{
    const std::vector<std::string> &names = scene().names;
    if (names.size() < 2)
        return;
    QMenu *menu = addMenu(tr("distance to"));
    menu->setToolTipsVisible(true);
    menu->menuAction()->setCheckable(true);
    menu->menuAction()->setChecked(current.what == QuantityKind::distance);
    const QString own = boundTo({QuantityKind::distance, current.body}, m_run.selected()).body;
    int left = 0;
    for (const std::string &each : names) {
        const QString name = QString::fromStdString(each);
        if (name == own)
            continue;
        if (menu->actions().size() >= mostBodies) {
            ++left;
            continue;
        }
        addChoice(*menu, bodyTitle(name), {QuantityKind::distance, current.body, name},
                  current.what == QuantityKind::distance && current.other == name);
    }
    addRest(*menu, left);
}

void QuantityMenu::addBodies(const Quantity &current)
{
    QMenu *menu = addMenu(tr("of which body"));
    menu->setToolTipsVisible(true);
    Quantity choice = current;
    choice.body.clear();
    addChoice(*menu, tr("the selected one: %1").arg(bodyTitle(m_run.selected())), choice,
              current.body.isEmpty());
    menu->addSeparator();
    const std::vector<std::string> &names = scene().names;
    const int count = std::min(mostBodies, static_cast<int>(names.size()));
    for (int i = 0; i < count; ++i) {
        choice.body = QString::fromStdString(names[static_cast<std::size_t>(i)]);
        addChoice(*menu, bodyTitle(choice.body), choice, choice.body == current.body);
    }
    addRest(*menu, static_cast<int>(names.size()) - count);
}

}
