#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>
#include <QPixmap>
#include <QTimer>

#include <vector>

class QGridLayout;
class QToolButton;

namespace app {

/// Pictures with a title each, in a popup: a click or Space takes one, arrow keys go from one to the next.
class CardGallery : public QFrame
{
    Q_OBJECT

public:
    /// Shows what there is to choose from above or below `anchor`, where there is room.
    void popUp(const QWidget &anchor);
    const std::vector<QToolButton *> &cards() const { return m_cards; }

protected:
    /// The edge that it has in common with what it hangs from.
    enum class Edge { left, right };
    struct Shape
    {
        int columns = 1;
        QSize picture; ///< px
        Edge edge = Edge::left;
    };
    struct Card
    {
        QString title;
        QString help;
        QString tip;
    };

    CardGallery(const Shape &shape, const Theme &theme, QWidget *parent);

    virtual std::vector<Card> contents() const = 0;
    /// The picture of one card, as large as the shape says; none where there is none.
    virtual QPixmap picture(std::size_t index) = 0;
    /// One was chosen, and the gallery is closed.
    virtual void take(std::size_t index) = 0;

    const Theme &theme() const { return m_theme; }
    QSize pictureSize() const { return m_shape.picture; }
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill();
    void paintNext();
    QToolButton *button(const Card &card, std::size_t index);

    Shape m_shape;
    const Theme &m_theme;
    QGridLayout *m_grid;
    std::vector<QToolButton *> m_cards;
    std::size_t m_painted = 0; ///< cards that have their picture
    QTimer m_later;
};

}
