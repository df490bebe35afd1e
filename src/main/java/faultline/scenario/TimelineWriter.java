package faultline.scenario;

import faultline.engine.Setup.Timed;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.List;

/** Writes the timeline. A fault whose mending comes next in the list is written as one element with {@code until}. */
final class TimelineWriter {

    private TimelineWriter() {
    }

    static void timeline(List<Timed> commands, XmlOut out) {
        out.begin("timeline");
        int next = 0;
        while (next < commands.size()) {
            Timed timed = commands.get(next);
            boolean joined = next + 1 < commands.size() && isMendedBy(timed, commands.get(next + 1));
            if (joined) {
                Command.InjectFault inject = (Command.InjectFault) timed.command();
                fault("fault", timed.at(), inject.sensor(), inject.fault(), out).set("until", commands.get(next + 1).at()).end();
            } else {
                command(timed, out);
            }
            next += joined ? 2 : 1;
        }
        out.end();
    }

    private static boolean isMendedBy(Timed first, Timed second) {
        return first.command() instanceof Command.InjectFault inject && second.at() > first.at()
                && second.command().equals(new Command.ClearFault(inject.sensor(), inject.fault()));
    }

    private static XmlOut fault(String name, double at, String sensor, Fault fault, XmlOut out) {
        begin(name, at, out).set("sensor", sensor).set("kind", fault.kind().fileName());
        return fault.kind().takesValue() ? out.set("value", fault.value()) : out;
    }

    private static XmlOut begin(String name, double at, XmlOut out) {
        return out.begin(name).set("at", at);
    }

    private static void command(Timed timed, XmlOut out) {
        double at = timed.at();
        Command command = timed.command();
        if (command instanceof Command.InjectFault inject) {
            fault("fault", at, inject.sensor(), inject.fault(), out).end();
        } else if (command instanceof Command.ClearFault clear) {
            fault("mend", at, clear.sensor(), clear.fault(), out).end();
        } else if (command instanceof Command.ClearFaults clear) {
            begin("mend", at, out).set("sensor", clear.sensor()).end();
        } else if (command instanceof Command.SwitchSensor change) {
            begin("switch", at, out).set("sensor", change.sensor()).set("on", change.on()).end();
        } else if (command instanceof Command.TuneSensor tune) {
            RobotWriter.settings(tune.sensor(), begin("tune", at, out).set("sensor", tune.sensor().id())).end();
        } else {
            onWorld(command, at, out);
        }
    }

    private static void onWorld(Command command, double at, XmlOut out) {
        if (command instanceof Command.MoveObstacle move) {
            WorldWriter.pose(move.pose(), begin("move", at, out).set("obstacle", move.obstacle())).end();
        } else if (command instanceof Command.PutObstacle put) {
            begin("put", at, out);
            WorldWriter.obstacle(put.obstacle(), out);
            out.end();
        } else if (command instanceof Command.RemoveObstacle remove) {
            begin("remove", at, out).set("obstacle", remove.obstacle()).end();
        } else if (command instanceof Command.SetPlatform platform) {
            begin("platform", at, out).set("length", platform.length()).set("width", platform.width()).set("speed", platform.speed()).end();
        }
    }
}
