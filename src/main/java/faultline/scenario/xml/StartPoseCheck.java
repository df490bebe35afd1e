package faultline.scenario.xml;

import faultline.engine.SimulationSetup;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.world.Clearance;
import faultline.world.WorldSpec;

/** Whether the robot can start where a file puts it. */
final class StartPoseCheck {

    private StartPoseCheck() {}

    static void check(XmlElement robot, SimulationSetup setup, Problems complaints) {
        WorldSpec world = setup.world();
        Vector2 start = setup.start().position();
        if (world.enclosed()
                && !(start.x() > 0 && start.x() < world.width() && start.y() > 0 && start.y() < world.height())) {
            complaints.add(
                    robot,
                    describeStart(start) + " outside of the enclosed world, allowed is x from 0 to "
                            + DecimalText.format(world.width()) + " and y from 0 to "
                            + DecimalText.format(world.height()));
            return;
        }
        Clearance.findObstruction(world, setup.robot(), setup.start())
                .ifPresent(obstacle -> complaints.add(
                        robot,
                        describeStart(start) + " where it touches or overlaps " + MessageText.quoted(obstacle)
                                + ", allowed is a place with room for the whole platform"));
    }

    private static String describeStart(Vector2 start) {
        return "<robot> starts at " + DecimalText.format(start.x()) + "," + DecimalText.format(start.y());
    }
}
