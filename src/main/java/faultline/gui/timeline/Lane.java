package faultline.gui.timeline;

import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.robot.MotorSide;

/** A lane of the time line. */
public sealed interface Lane {

    /** The lane of all items that concern neither a sensor nor motors. */
    Lane OTHER = new OtherLane();

    /** Returns the name that the window shows. */
    String label();

    /** The lane of a sensor, by its id. */
    record SensorLane(String id) implements Lane {
        @Override
        public String label() {
            return id;
        }
    }

    /** The lane of the motors of a side. */
    record MotorLane(MotorSide side) implements Lane {
        @Override
        public String label() {
            return FaultText.motors(side);
        }
    }

    /** See {@link #OTHER}. */
    record OtherLane() implements Lane {
        @Override
        public String label() {
            return Messages.get("timeline.world");
        }
    }
}
