package faultline.gui.edit;

import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Names edits for menus, from each command and its inverse. */
final class EditNames {

    private static final String SEVERAL = "edit.several";

    private final Command undo;

    private EditNames(CommandResult result) {
        this.undo = result.inverse().get(0);
    }

    /**
     * The name of one command's edit: the keys of the messages for one and for several such commands, and the id of
     * what is edited.
     */
    record EditName(String key, String severalKey, String subject) {
        EditName(String key, String subject) {
            this(key, SEVERAL, subject);
        }
    }

    static String nameOf(List<CommandResult> results) {
        CommandResult first = results.get(0);
        EditName name = new EditNames(first).nameOf(first.command());
        if (results.size() == 1) {
            return Messages.get(name.key(), name.subject());
        }
        boolean alike = results.stream()
                .allMatch(
                        result -> result.command().getClass() == first.command().getClass());
        return Messages.get(alike ? name.severalKey() : SEVERAL, Integer.toString(results.size()));
    }

    private EditName nameOf(Command changed) {
        return changed.match(new Command.CommandCases<>(
                switchSensor ->
                        new EditName(switchSensor.on() ? "edit.switchOn" : "edit.switchOff", switchSensor.sensor()),
                configureSensor -> new EditName(
                        sensorKey(configureSensor.sensor()),
                        configureSensor.sensor().id()),
                injectFault -> new EditName("edit.fault", injectFault.sensor()),
                clearFault -> new EditName("edit.repair", clearFault.sensor()),
                clearFaults -> new EditName("edit.repair", "edit.repairSeveral", clearFaults.sensor()),
                injectMotorFault -> new EditName("edit.fault", FaultText.motors(injectMotorFault.motor())),
                clearMotorFault -> new EditName("edit.repair", FaultText.motors(clearMotorFault.motor())),
                clearMotorFaults ->
                        new EditName("edit.repair", "edit.repairMotors", FaultText.motors(clearMotorFaults.motor())),
                this::nameOfMove,
                this::nameOfPlacement,
                removeObstacle -> new EditName("edit.remove", "edit.removeSeveral", removeObstacle.obstacle()),
                setPlatform -> {
                    boolean speed = undo instanceof Command.SetPlatform back && back.speed() != setPlatform.speed();
                    return new EditName(speed ? "edit.speed" : "edit.platform", "");
                },
                configureController -> new EditName("edit.controller", "")));
    }

    private String sensorKey(SensorSpec now) {
        SensorSpec before = undo instanceof Command.ConfigureSensor back ? back.sensor() : now;
        Map<String, SensorSpec> single = new LinkedHashMap<>();
        single.put("edit.range", before.withRange(now.range()));
        single.put("edit.cone", before.withCone(now.cone()));
        single.put("edit.bearing", before.withBearing(now.bearing()));
        single.put("edit.mountPosition", before.withMountPosition(now.mountPosition()));
        single.put("edit.noise", before.withNoise(now.noise()));
        return single.entrySet().stream()
                .filter(change -> change.getValue().equals(now))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("edit.tune");
    }

    private EditName nameOfMove(Command.MoveObstacle command) {
        boolean turns = undo instanceof Command.MoveObstacle back
                && back.pose().heading() != command.pose().heading();
        return turns
                ? new EditName("edit.turn", "edit.turnSeveral", command.obstacle())
                : new EditName("edit.move", "edit.moveSeveral", command.obstacle());
    }

    private EditName nameOfPlacement(Command.PlaceObstacle command) {
        Obstacle now = command.obstacle();
        if (!(undo instanceof Command.PlaceObstacle back)) {
            return new EditName("edit.add", "edit.addSeveral", now.id());
        }
        String key = changesOnlySpeed(back.obstacle(), now) ? "edit.motionSpeed" : "edit.change";
        return new EditName(key, "edit.changeSeveral", now.id());
    }

    private static boolean changesOnlySpeed(Obstacle before, Obstacle now) {
        return before.isMoving()
                && !before.motion().equals(now.motion())
                && before.motion().withSpeed(now.motion().speed()).equals(now.motion());
    }
}
