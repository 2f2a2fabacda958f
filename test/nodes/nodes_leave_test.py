"""The nodes leave in time, whatever time and master do."""
import os
import signal
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402

LEFT_S = 2.0


def test_where_simulated_time_never_begins_the_planner_says_so_and_leaves():
    with ws.WalkingSession(sim_time=True, nodes=("planner",)) as timeless:
        ws.wait_for(lambda: "no time comes on /clock" in timeless.log("planner"), 20.0,
                    "a sentence about /clock")
        assert timeless.leave("planner")[1] < LEFT_S
        timeless.start("planner")
        ws.wait_for(lambda: timeless.log("planner").count("no time comes on /clock") > 1, 20.0,
                    "the planner")
        timeless.send_signal("master", signal.SIGSTOP)  # one that hangs
        assert timeless.leave("planner", signal.SIGTERM)[1] < LEFT_S


def test_every_node_leaves_though_the_master_hangs():
    nodes = ("repertoire_server", "simulated_robot", "executor")
    with ws.WalkingSession(nodes=nodes) as session:
        for node in nodes:
            ws.wait_for(lambda node=node: session.knows(node), 20.0, node)
        session.send_signal("master", signal.SIGSTOP)
        for node in nodes:
            code, left_s = session.leave(node, signal.SIGTERM)
            assert code == 0, node
            assert left_s < LEFT_S, node
