"""A* on a lattice of poses, whose moves are certified as they are needed."""

import heapq
from itertools import count

import numpy as np

import berthing as bt

STEP_M, TURN_RAD, REACH_M = 0.5, np.pi / 12, 2.0
MOVES = list(np.vstack([np.eye(3), -np.eye(3)]).astype(int))
START, GOAL = (0, 0, 6), (19, 0, 0)  # steps in x and y, and turns about z


def pose(node):
    half = 0.5 * TURN_RAD * node[2]
    return [STEP_M * node[0], STEP_M * node[1], 0.0, np.cos(half), 0.0, 0.0, np.sin(half)]


def cost(move):
    return STEP_M * abs(move[0]) + STEP_M * abs(move[1]) + REACH_M * TURN_RAD * abs(move[2])


def search(checker):
    order = count()
    open_, best, came = [(0.0, next(order), START)], {START: 0.0}, {}
    done = set()
    while open_:
        node = heapq.heappop(open_)[2]
        if node == GOAL:
            way = [node]
            while way[-1] in came:
                way.append(came[way[-1]])
            return way[::-1], len(done)
        if node in done:
            continue
        done.add(node)
        ahead = [tuple(int(i) for i in np.add(node, move)) for move in MOVES]
        legs = checker.motion(pose(node), [pose(other) for other in ahead])
        for other, move, excess in zip(ahead, MOVES, legs.excess_m, strict=True):
            new = best[node] + cost(move)
            if excess >= 0.0 and new < best.get(other, np.inf):
                best[other], came[other] = new, node
                to_go = cost(np.subtract(GOAL, other))
                heapq.heappush(open_, (new + to_go, next(order), other))
    return None, len(done)


if __name__ == "__main__":
    checker = bt.Checker(bt.load("scenario-b-tight"))
    way, opened = search(checker)
    legs = checker.legs(checker.states(np.array([pose(node) for node in way])))
    assert legs.certified
    print(f"{len(way)} poses, {opened} opened, at least {min(legs.bound_m):.3f} m: certified")
