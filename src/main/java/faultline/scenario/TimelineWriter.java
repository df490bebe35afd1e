package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.xml.XmlWriter;
import faultline.sensor.Fault;
import faultline.sensor.FaultDescriptor;
import faultline.world.Command;
import java.util.List;

/** Writes the timeline. A fault that the next command clears is written as one element with {@code until}. */
final class TimelineWriter implements Command.Visitor<XmlWriter> {

    private final ControllerSpec.WallFollowing follower;
    private final XmlWriter out;
    private double time;
    /** The command that clears the fault that was written last; null if the last command added no fault. */
    private Command clearing;

    private TimelineWriter(ControllerSpec.WallFollowing follower, XmlWriter out) {
        this.follower = follower;
        this.out = out;
    }

    /** Writes the commands of a scenario, whose controller has the values of omitted attributes. */
    static void write(List<TimedCommand> commands, ControllerSpec controller, XmlWriter out) {
        TimelineWriter writer = new TimelineWriter(ControllerReader.defaultsFor(controller), out);
        out.beginElement("timeline");
        for (int i = 0; i < commands.size(); i++) {
            writer.time = commands.get(i).time();
            writer.clearing = null;
            XmlWriter element = commands.get(i).command().accept(writer);
            if (i + 1 < commands.size() && writer.isCleared(commands.get(i + 1))) {
                i++;
                element.attribute("until", commands.get(i).time());
            }
            element.endElement();
        }
        out.endElement();
    }

    private boolean isCleared(TimedCommand next) {
        return next.time() > time && next.command().equals(clearing);
    }

    private XmlWriter begin(String name) {
        return out.beginElement(name).attribute("at", time);
    }

    /** Writes a fault into the open element; its number and its length are ignored by kinds without them. */
    private XmlWriter writeFault(FaultDescriptor<?> kind, double value, double length) {
        out.attribute("kind", kind.fileName());
        if (kind.takesValue()) {
            out.attribute("value", value);
        }
        return kind.takesLength() ? out.attribute("length", length) : out;
    }

    private XmlWriter beginFault(String name, String sensor, Fault fault) {
        begin(name).attribute("sensor", sensor);
        return writeFault(fault.kind(), fault.value(), fault.length());
    }

    @Override
    public XmlWriter visit(Command.SwitchSensor command) {
        return begin("switch").attribute("sensor", command.sensor()).attribute("on", command.on());
    }

    @Override
    public XmlWriter visit(Command.ConfigureSensor command) {
        return RobotWriter.writeSettings(
                command.sensor(),
                begin("tune").attribute("sensor", command.sensor().id()));
    }

    @Override
    public XmlWriter visit(Command.InjectFault command) {
        clearing = new Command.ClearFault(command.sensor(), command.fault());
        return beginFault("fault", command.sensor(), command.fault());
    }

    @Override
    public XmlWriter visit(Command.ClearFault command) {
        return beginFault("mend", command.sensor(), command.fault());
    }

    @Override
    public XmlWriter visit(Command.ClearFaults command) {
        return begin("mend").attribute("sensor", command.sensor());
    }

    @Override
    public XmlWriter visit(Command.InjectMotorFault command) {
        clearing = new Command.ClearMotorFault(command.motor(), command.fault());
        return beginMotorFault("fault", command.motor(), command.fault());
    }

    @Override
    public XmlWriter visit(Command.ClearMotorFault command) {
        return beginMotorFault("mend", command.motor(), command.fault());
    }

    @Override
    public XmlWriter visit(Command.ClearMotorFaults command) {
        return begin("mend").attribute("motor", command.motor().fileName());
    }

    private XmlWriter beginMotorFault(String name, MotorSide motor, MotorFault fault) {
        begin(name).attribute("motor", motor.fileName());
        return writeFault(fault.kind(), fault.value(), 0);
    }

    @Override
    public XmlWriter visit(Command.MoveObstacle command) {
        return WorldWriter.writePose(command.pose(), begin("move").attribute("obstacle", command.obstacle()));
    }

    @Override
    public XmlWriter visit(Command.PlaceObstacle command) {
        begin("put");
        WorldWriter.writeObstacle(command.obstacle(), out);
        return out;
    }

    @Override
    public XmlWriter visit(Command.RemoveObstacle command) {
        return begin("remove").attribute("obstacle", command.obstacle());
    }

    @Override
    public XmlWriter visit(Command.SetPlatform command) {
        return begin("platform")
                .attribute("length", command.length())
                .attribute("width", command.width())
                .attribute("speed", command.speed());
    }

    @Override
    public XmlWriter visit(Command.ConfigureController command) {
        return command.controller().accept(new ControllerWriter(begin("controller"), follower, true));
    }
}
