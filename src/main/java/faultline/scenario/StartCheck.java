package faultline.scenario;

import faultline.engine.Setup;
import faultline.geometry.Vec;
import faultline.world.Clearance;
import faultline.world.WorldSpec;

/** Whether the robot can start where a file puts it. */
final class StartCheck {

    private StartCheck() {
    }

    static void check(Node robot, Setup setup, Complaints complaints) {
        WorldSpec world = setup.world();
        Vec start = setup.start().position();
        if (world.enclosed() && !(start.x() > 0 && start.x() < world.width() && start.y() > 0 && start.y() < world.height())) {
            complaints.add(robot, where(start) + " outside of the enclosed world, allowed is x from 0 to " + Numbers.toText(world.width())
                    + " and y from 0 to " + Numbers.toText(world.height()));
            return;
        }
        Clearance.obstructing(world, setup.robot(), setup.start()).ifPresent(obstacle -> complaints.add(robot,
                where(start) + " where it touches or overlaps " + Quoting.quoted(obstacle)
                + ", allowed is a place with room for the whole platform"));
    }

    private static String where(Vec start) {
        return "<robot> starts at " + Numbers.toText(start.x()) + "," + Numbers.toText(start.y());
    }
}
