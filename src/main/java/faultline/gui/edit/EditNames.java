package faultline.gui.edit;

import faultline.gui.text.Texts;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What edits are called in menus. */
final class EditNames {

    private EditNames() {
    }

    static String of(List<Step> steps) {
        Step first = steps.get(0);
        if (steps.size() == 1) {
            return of(first.redo(), first.undo());
        }
        boolean alike = steps.stream().allMatch(step -> step.redo().getClass() == first.redo().getClass());
        return Texts.text(alike ? several(first) : "edit.several", Integer.toString(steps.size()));
    }

    private static String several(Step first) {
        if (first.redo() instanceof Command.MoveObstacle) {
            return isTurn(first.redo(), first.undo()) ? "edit.turnSeveral" : "edit.moveSeveral";
        }
        if (first.redo() instanceof Command.RemoveObstacle) {
            return "edit.removeSeveral";
        }
        if (first.redo() instanceof Command.ClearFaults) {
            return "edit.mendSeveral";
        }
        boolean adds = first.redo() instanceof Command.PutObstacle && first.undo().get(0) instanceof Command.RemoveObstacle;
        return adds ? "edit.addSeveral" : first.redo() instanceof Command.PutObstacle ? "edit.changeSeveral" : "edit.several";
    }

    private static String of(Command redo, List<Command> undo) {
        if (redo instanceof Command.MoveObstacle move) {
            return Texts.text(isTurn(redo, undo) ? "edit.turn" : "edit.move", move.obstacle());
        }
        if (redo instanceof Command.PutObstacle put) {
            return Texts.text(put(put.obstacle(), undo.get(0)), put.obstacle().id());
        }
        if (redo instanceof Command.RemoveObstacle remove) {
            return Texts.text("edit.remove", remove.obstacle());
        }
        return redo instanceof Command.SetPlatform platform ? Texts.text(platform(platform, undo)) : ofSensor(redo, undo);
    }

    private static boolean isTurn(Command redo, List<Command> undo) {
        return redo instanceof Command.MoveObstacle move && undo.get(0) instanceof Command.MoveObstacle back
                && back.pose().heading() != move.pose().heading();
    }

    private static String put(Obstacle now, Command undo) {
        boolean speed = undo instanceof Command.PutObstacle back && !back.obstacle().motion().equals(now.motion())
                && back.obstacle().motion().flatMap(before -> now.motion().map(way -> before.at(way.speed()))).equals(now.motion());
        return undo instanceof Command.RemoveObstacle ? "edit.add" : speed ? "edit.waySpeed" : "edit.change";
    }

    private static String platform(Command.SetPlatform platform, List<Command> undo) {
        boolean speed = undo.get(0) instanceof Command.SetPlatform back && back.speed() != platform.speed();
        return speed ? "edit.speed" : "edit.platform";
    }

    private static String ofSensor(Command redo, List<Command> undo) {
        if (redo instanceof Command.SwitchSensor change) {
            return Texts.text(change.on() ? "edit.switchOn" : "edit.switchOff", change.sensor());
        }
        if (redo instanceof Command.TuneSensor tune) {
            return Texts.text(tuned(tune.sensor(), undo), tune.sensor().id());
        }
        if (redo instanceof Command.InjectFault fault) {
            return Texts.text("edit.fault", fault.sensor());
        }
        return Texts.text("edit.mend", redo instanceof Command.ClearFault one ? one.sensor() : ((Command.ClearFaults) redo).sensor());
    }

    private static String tuned(SensorSpec now, List<Command> undo) {
        SensorSpec before = undo.get(0) instanceof Command.TuneSensor back ? back.sensor() : now;
        Map<String, SensorSpec> single = new LinkedHashMap<>();
        single.put("edit.range", before.withRange(now.range()));
        single.put("edit.cone", before.withCone(now.cone()));
        single.put("edit.bearing", before.withBearing(now.bearing()));
        single.put("edit.seat", before.withSeat(now.seat()));
        single.put("edit.noise", before.withNoise(now.noise()));
        return single.entrySet().stream().filter(change -> change.getValue().equals(now)).map(Map.Entry::getKey).findFirst().orElse("edit.tune");
    }
}
