package faultline.gui.gallery;

import faultline.gui.text.Messages;
import java.util.Set;

/** A group of examples. An example is of the first group whose files include it, or else of {@link #ROOMS}. */
enum ExampleGroup {
    /** All examples. */
    ALL(Set.of()),
    /** Three short runs that show what the program is for: a sensor fails, and the robot carries on or not. */
    FAULT_STORIES(Set.of("front-sensor-dies.xml", "left-sensor-stuck.xml", "one-sensor-alone.xml")),
    /** More faults, and surfaces that deceive sensors. */
    FAULTS(Set.of("every-fault.xml", "left-sensor-off.xml", "noisy-sensors.xml", "glass-partition.xml", "mirror.xml")),
    /** Obstacles that move or are struck. */
    MOVING(Set.of(
            "corridor-with-visitor.xml", "three-visitors.xml", "struck-by-a-visitor.xml", "collision-on-purpose.xml")),
    /** Rooms and corners without faults. */
    ROOMS(Set.of());

    private final Set<String> files;

    ExampleGroup(Set<String> files) {
        this.files = files;
    }

    /** Returns the group of an example, given the name of its file. */
    static ExampleGroup of(String file) {
        for (ExampleGroup group : values()) {
            if (group.files.contains(file)) {
                return group;
            }
        }
        return ROOMS;
    }

    /** Returns whether an example is shown if this group is selected. */
    boolean shows(Example example) {
        return this == ALL || of(example.file()) == this;
    }

    /** Returns the name in the user's language. */
    @Override
    public String toString() {
        return Messages.get("gallery.group." + name());
    }
}
