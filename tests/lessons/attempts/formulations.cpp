#include "tests/lessons/attempts/formulations.h"

namespace support {

namespace {

constexpr Formulation formulations[] = {
    {"single_spring", "drag", "throw", R"(Vec2 way = hand - foot.position;
foot.position += way;
foot.velocity = way;)"},
    {"single_spring", "fixed_centre", "pull", R"(foot.velocity.x += k * (centre_x - foot.position.x);
foot.velocity.y -= k * (foot.position.y - centre_y);)"},
    {"single_spring", "moving_body", "move", R"(foot.position += damp * foot.velocity;
foot.velocity -= (1 - damp) * foot.velocity;)"},
    {"single_spring", "offset", "target", "Vec2 target = Vec2(offset + body.position.x, body.position.y);"},
    {"single_spring", "radial", "target", R"(Vec2 way = foot.position - body.position;
double far = sqrt(way.x * way.x + way.y * way.y);
Vec2 target = body.position + Vec2(radius, 0);
if (far > 0)
    target = body.position + way / far * radius;)"},
    {"single_spring", "radial", "frame", R"(Vec2 ring(Vec2 centre, Vec2 at)
{
    Vec2 way = at - centre;
    double far = length(way);
    return far == 0 ? centre + Vec2(radius, 0) : centre + radius / far * way;
}

void frame()
{
    if (body.held)
        body.position = hand;
    if (foot.held)
    {
        foot.velocity = hand - foot.position;
        foot.position += foot.velocity;
        return;
    }
    foot.velocity = damp * (foot.velocity + k * (ring(body.position, foot.position) - foot.position));
    foot.position += foot.velocity;
})"},
    {"two_body", "mutual", "opposite", "body.velocity -= k * (nearest(foot, body) - foot.position);"},
    {"two_body", "mutual", "nearest", R"(Vec2 way = me.position - anchor.position;
if (length(way) == 0)
    return anchor.position + Vec2(radius, 0);
return anchor.position + way * (radius / length(way));)"},
    {"two_body", "leg_line", "frame", R"(void hold(Body me)
{
    me.velocity = hand - me.position;
    me.position = hand;
}

void go(Body me, Body other)
{
    double angle = atan2(me.position.y - other.position.y, me.position.x - other.position.x);
    me.velocity.x += k * (other.position.x + radius * cos(angle) - me.position.x);
    me.velocity.y += k * (other.position.y + radius * sin(angle) - me.position.y);
    me.velocity = me.velocity * damp;
    me.position = me.position + me.velocity;
}

void frame()
{
    if (body.held)
        hold(body);
    if (foot.held)
        hold(foot);
    else
        go(foot, body);
    if (!body.held)
        go(body, foot);
})"},
    {"multi_foot", "two_feet", "both", "body.velocity += pull(body, feet[1]) + pull(body, feet[0]);"},
    {"multi_foot", "any_number", "loop", R"(Vec2 all(0, 0);
int i = feet.count;
while (i > 0)
{
    i--;
    all += pull(body, feet[i]);
}
body.velocity += all;)"},
    {"multi_foot", "any_number", "follow", R"(Vec2 before = me.position;
me.position = hand;
me.velocity = me.position - before;)"},
    {"multi_foot", "grown_feet", "frame", R"(Vec2 place(Vec2 me, Vec2 anchor)
{
    double angle = atan2(me.y - anchor.y, me.x - anchor.x);
    return anchor + Vec2(radius * cos(angle), radius * sin(angle));
}

bool isInHand(Body me)
{
    if (!me.held)
        return false;
    me.velocity = hand - me.position;
    me.position = hand;
    return true;
}

void frame()
{
    bool bodyHeld = isInHand(body);
    for (int i = 0; i < feet.count; i++)
    {
        if (isInHand(feet[i]))
            continue;
        feet[i].velocity += k * (place(feet[i].position, body.position) - feet[i].position);
        feet[i].velocity *= damp;
        feet[i].position += feet[i].velocity;
    }
    if (bodyHeld)
        return;
    Vec2 sum(0, 0);
    for (int i = feet.count - 1; i >= 0; i--)
        sum += place(body.position, feet[i].position) - body.position;
    body.velocity = (body.velocity + k * sum) * damp;
    body.position += body.velocity;
})"},
    {"gravity_walls", "walls", "wall", R"(double edge = right - me.radius;
if (edge < me.position.x)
    me.velocity.x = -bounce * me.velocity.x;
me.position.x = min(edge, me.position.x);)"},
    {"gravity_walls", "walls", "floor", R"(double deep = me.position.y + me.radius - floor;
if (deep > 0)
{
    me.velocity.y = -me.velocity.y * bounce;
    me.position.y -= deep;
})"},
    {"gravity_walls", "gravity", "gravity", "me.velocity = me.velocity + Vec2(0, gravity);"},
    {"gravity_walls", "gravity", "frame", R"(Vec2 spring(Vec2 me, Vec2 anchor)
{
    double angle = atan2(me.y - anchor.y, me.x - anchor.x);
    return k * (anchor - me + Vec2(radius * cos(angle), radius * sin(angle)));
}

bool isInHand(Body me)
{
    if (me.held)
        me.velocity = hand - me.position;
    if (me.held)
        me.position = hand;
    return me.held;
}

void go(Body me, Vec2 force)
{
    me.velocity = damp * (me.velocity + force + Vec2(0, gravity));
    me.position += me.velocity;
    double least = left + me.radius;
    double most = right - me.radius;
    if (me.position.x != clamp(me.position.x, least, most))
        me.velocity.x *= -bounce;
    me.position.x = clamp(me.position.x, least, most);
    if (me.position.y + me.radius > floor)
    {
        me.velocity.y *= -bounce;
        me.position.y = floor - me.radius;
    }
}

void frame()
{
    bool held = isInHand(body);
    Vec2 sum(0, 0);
    for (int i = 0; i < feet.count; i++)
    {
        if (!isInHand(feet[i]))
            go(feet[i], spring(feet[i].position, body.position));
        sum += spring(body.position, feet[i].position);
    }
    if (!held)
        go(body, sum);
})"},
    {"walking_gait", "bones", "target",
     "Vec2 target = body.position + leg * Vec2(cos(angle + pi), sin(angle + pi));"},
    {"walking_gait", "swing", "target", R"(double turned = gait + angle;
Vec2 target(body.position.x - leg * cos(turned), body.position.y + drop - leg * sin(turned));)"},
    {"walking_gait", "body_pulled", "forces", R"(if (!body.held)
    body.velocity += -1 * force;
if (foot.held)
    return;
foot.velocity += force;)"},
    {"walking_gait", "ground", "ground", R"(bool isFoot = me != body;
if (isFoot && ground < me.position.y)
{
    me.velocity = Vec2(traction == 0 ? 0.0 : me.velocity.x, -bounce * me.velocity.y);
    me.position = Vec2(me.position.x, ground);
})"},
    {"walking_gait", "ground", "frame", R"(void hold(Body me)
{
    if (me.held)
    {
        me.velocity = hand - me.position;
        me.position = hand;
    }
}

void go(Body me)
{
    me.velocity = damp * (me.velocity + Vec2(0, gravity));
    me.position += me.velocity;
}

void frame()
{
    for (int i = 0; i < 2; i++)
        hold(feet[i]);
    hold(body);
    for (int i = 0; i < 2; i++)
    {
        double turned = i * pi + gait;
        Vec2 place(body.position.x - leg * cos(turned), body.position.y - leg * sin(turned) + drop);
        Vec2 force = (place - feet[i].position) * k;
        if (!feet[i].held)
            feet[i].velocity += force;
        if (!body.held)
            body.velocity -= force;
    }
    for (int i = 0; i < 2; i++)
    {
        Body foot = feet[i];
        if (foot.held)
            continue;
        go(foot);
        if (foot.position.y <= ground)
            continue;
        foot.position.y = ground;
        foot.velocity = Vec2(traction == 0 ? 0.0 : foot.velocity.x, -bounce * foot.velocity.y);
    }
    if (!body.held)
        go(body);
    gait = gait + speed;
})"},
    {"swaying_tree", "branches", "place", R"(for (int i = branch.children.count - 1; i >= 0; i--)
    place(branch.children[i], reach(branch) * branch.scale + branch.position);)"},
    {"swaying_tree", "towards_pointer", "turn", "branch.angle = 180 / pi * atan2(way.y, way.x);"},
    {"swaying_tree", "towards_pointer", "frame", R"(void go(Body branch)
{
    if (branch.held)
        branch.position = hand;
    else if (pointer_down)
        branch.angle =
            atan2(pointer.y - branch.position.y, pointer.x - branch.position.x) * 180 / pi;
    double rad = branch.angle * pi / 180;
    for (int i = 0; i < branch.children.count; i++)
    {
        branch.children[i].position =
            branch.position + base_length * Vec2(cos(rad), sin(rad)) * branch.scale;
        go(branch.children[i]);
    }
}

void frame()
{
    go(branches[0]);
})"},
    {"swaying_tree", "rest", "rest", R"(double past = branch.angle - branch.rest;
if (past > 1 || past < -1)
    branch.angle -= past / ease;)"},
    {"rigid_constraint", "pair", "error", "double error = sqrt(dot(d, d)) - stick.length;"},
    {"rigid_constraint", "shared_error", "parts", R"(double part_of_b = (1 - share_of_a) * error;
double part_of_a = error - part_of_b;)"},
    {"rigid_constraint", "list", "loop", R"(int next = 0;
while (next < sticks.count)
{
    enforce(sticks[next]);
    next++;
})"},
    {"rigid_constraint", "list", "frame", R"(void fix(Stick one)
{
    Vec2 way = one.b.position - one.a.position;
    double angle = atan2(way.y, way.x);
    Vec2 move = (length(way) - one.length) * Vec2(cos(angle), sin(angle));
    double share = one.share;
    if (one.b.held)
        share = 1;
    if (one.a.held)
        share = 0;
    one.a.position += share * move;
    one.b.position -= (1 - share) * move;
}

void frame()
{
    if (pointer_known)
        points[0].position = pointer;
    for (int i = 0; i < points.count; i++)
        if (points[i].held)
            points[i].position = hand;
    for (int i = 0; i < sticks.count; i++)
        fix(sticks[i]);
})"},
    {"rigid_constraint", "verlet", "move", R"(point.velocity.y += gravity;
point.velocity *= damp;
point.position += point.velocity;)"},
    {"rigid_constraint", "verlet", "came", R"(for (int i = points.count - 1; i >= 0; i--)
    points[i].velocity = -1 * (points[i].before - points[i].position);)"},
    {"codeling", "motor", "pull", "Vec2 pull = (target - lead.position) * (k * pow(dt, 2));"},
    {"codeling", "orientation", "tail", R"(Vec2 none(0, 0);
lead.position += tail.held ? correction : none;
tail.position -= tail.held ? none : correction;)"},
    {"codeling", "anticipation", "shift", R"(Vec2 start = lead.position;
lead.position -= anticipation * (new_targets[i] - start);
lead.velocity += lead.position - start;)"},
    {"codeling", "anticipation", "frame", R"(void frame()
{
    if (lead.held)
    {
        lead.velocity = hand - lead.position;
        lead.position = hand;
    }
    else
    {
        for (int i = 0; i < new_targets.count; i++)
        {
            Vec2 away = lead.position - new_targets[i];
            lead.position += away * anticipation;
            lead.velocity += away * anticipation;
        }
        lead.velocity = keep * lead.velocity + k * dt * dt * (target - lead.position);
        lead.position += lead.velocity;
    }
    if (tail.held)
        tail.position = hand;
    Vec2 way = lead.position - tail.position;
    double angle = atan2(way.y, way.x);
    Vec2 closer = (length(way) - rest_length) * Vec2(cos(angle), sin(angle));
    if (tail.held)
        lead.position -= closer;
    else
        tail.position += closer;
})"},
    {"codeling", "volume", "width", R"(double spine = length(tail.position - lead.position);
if (spine < 10)
    spine = 10;
double wanted = 30 / spine * rest_length;)"}};

}

std::span<const Formulation> rightFormulations()
{
    return formulations;
}

}
