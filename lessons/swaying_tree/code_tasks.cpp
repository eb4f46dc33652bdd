#include "code_tasks.h"

#include "lessons/swaying_tree/text.h"

using namespace lessons;

namespace swaying_tree {

std::vector<CodeTask> branchesCodeTasks()
{
    return {
        {
            .id = "place",
            .title = Text::tr("a function that calls itself"),
            .text = Text::tr("Write where the **children begin**: where the branch ends. Each child then "
                             "places its own children in the same way."),
            .comment = Text::tr("Find the end of the branch, and place each child there."),
            .hints =
                {
                    Text::tr("The end is `reach(branch)` away from the beginning, if the branch is as large "
                             "as the trunk. A smaller one reaches `branch.scale` times as far."),
                    Text::tr("A loop over `branch.children.count` calls the function itself for each child."),
                    Text::tr("`Vec2 end = branch.position + branch.scale * …;` and in the loop "
                             "`place(branch.children[i], …);`"),
                },
            .nearMisses =
                {
                    {"for (int i = 0; i < branch.children.count; i++)\n    place(branch.children[i], "
                     "branch.position);",
                     Text::tr("All branches begin in one place: the children begin where the branch begins. "
                              "They belong at its end.")},
                    {"Vec2 end = branch.position + reach(branch);\nfor (int i = 0; i < "
                     "branch.children.count; i++)\n    place(branch.children[i], end);",
                     Text::tr("Each branch is as long as the trunk. Multiply by `branch.scale`.")},
                    {"Vec2 end = branch.position + branch.scale * reach(branch);\nplace(branch.children[0], "
                     "end);",
                     Text::tr(
                         "Only the first child follows. And a branch without children has no number 0.")},
                    {"Vec2 end = branch.position - branch.scale * reach(branch);\nfor (int i = 0; i < "
                     "branch.children.count; i++)\n    place(branch.children[i], end);",
                     Text::tr("The tree grows from the wrong end: the branch leads from its beginning to its "
                              "end with a plus.")},
                },
        },
    };
}

std::vector<CodeTask> towardsPointerCodeTasks()
{
    return {
        {
            .id = "turn",
            .title = Text::tr("turn towards the pointer"),
            .text = Text::tr("Write the **angle** with which the branch points along `way`. An angle of a "
                             "branch is in degrees."),
            .comment = Text::tr("Set the angle of the branch."),
            .hints =
                {
                    Text::tr("`atan2` makes an angle of a y and an x. It is in radians."),
                    Text::tr("The function `degrees()` returns how many degrees are in one radian."),
                    Text::tr("`branch.angle = atan2(…, …) * …;`"),
                },
            .nearMisses =
                {
                    {"branch.angle = atan2(way.y, way.x);",
                     Text::tr("This angle is in radians. Multiply by `degrees()`.")},
                    {"branch.angle = atan2(way.x, way.y) * degrees();",
                     Text::tr("x and y are swapped in `atan2`: y comes first.")},
                    {"branch.angle += atan2(way.y, way.x) * degrees();",
                     Text::tr("With `+=` the branch turns on in each frame. Set the angle with `=`.")},
                    {"branch.angle = -atan2(way.y, way.x) * degrees();",
                     Text::tr("The branch turns to the wrong side: y points down, and so does the angle.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text =
                Text::tr("**From the empty page:** write the whole frame of a tree that turns to the pointer "
                         "while its button is down. All its branches follow one function that calls itself."),
            .comment = Text::tr(
                "Write the whole frame. The names: branches[0], the trunk (each branch has position, angle, "
                "scale, held, children[i], children.count), base_length, hand, pointer, pointer_down."),
            .hints =
                {
                    Text::tr("`void move(Body branch, Vec2 origin)` places a branch and then calls itself "
                             "for its children. `frame` calls it for the trunk, which begins where it is."),
                    Text::tr("In `move`: the branch begins at `origin`, or at `hand` if it is held. If "
                             "`pointer_down`, and it is not held, it turns to the pointer. Its end is the "
                             "origin of its children."),
                    Text::tr("The angle is `atan2(way.y, way.x) * 180 / pi` with `Vec2 way = pointer - "
                             "branch.position`. The end is `branch.scale * base_length` away, in the "
                             "direction `Vec2(cos(rad), sin(rad))`."),
                },
            .nearMisses =
                {
                    {"branch.angle = atan2(way.x, way.y) * degrees();",
                     Text::tr("The rest is right, but x and y are swapped in `atan2`: y comes first."),
                     "turn"},
                    {"Vec2 end = branch.position + reach(branch);\nfor (int i = 0; i < "
                     "branch.children.count; i++)\n    move(branch.children[i], end);",
                     Text::tr("The rest is right, but each branch is as long as the trunk. Multiply by its "
                              "`scale`."),
                     "move"},
                },
        },
    };
}

std::vector<CodeTask> restCodeTasks()
{
    return {
        {
            .id = "rest",
            .title = Text::tr("back to rest"),
            .text = Text::tr("Write how a branch goes **back to rest**: each frame by the missing angle, "
                             "divided by **ease**. If less than 1° is missing, it stays."),
            .comment = Text::tr("Go a part of the way back to the angle at rest."),
            .hints =
                {
                    Text::tr("The missing angle leads from `branch.angle` to `branch.rest`."),
                    Text::tr("`abs` makes a number positive, so that both sides count."),
                    Text::tr(
                        "`double way = branch.rest - …;` and `if (abs(way) > 1) branch.angle += way / …;`"),
                },
            .nearMisses =
                {
                    {"double way = branch.rest - branch.angle;\nif (abs(way) > 1)\n    branch.angle += way;",
                     Text::tr("The branch jumps back at once. Divide by `ease`.")},
                    {"double way = branch.angle - branch.rest;\nif (abs(way) > 1)\n    branch.angle += way / "
                     "ease;",
                     Text::tr("The branch turns away from rest. Swap the two angles.")},
                    {"double way = branch.rest - branch.angle;\nif (way > 1)\n    branch.angle += way / "
                     "ease;",
                     Text::tr("The branch only goes back from one side. `abs(way)` counts both.")},
                    {"double way = branch.rest - branch.angle;\nbranch.angle += way / ease;",
                     Text::tr("It also moves when less than 1° is missing, so it never stops. An `if` ends "
                              "this.")},
                },
        },
    };
}

}
