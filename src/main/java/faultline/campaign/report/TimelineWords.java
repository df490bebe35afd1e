package faultline.campaign.report;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.io.DecimalText;
import faultline.sensor.FaultDescriptor;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;

/** The switches, faults and repairs of a timeline in words, with the names of scenario files. */
final class TimelineWords {

    /** The number of commands that are listed; a timeline may have thousands. */
    private static final int MAX_COMMANDS = 20;

    private TimelineWords() {}

    /** Returns words such as "front dropout=0.5 at 5 s, 2 other changes"; empty for an empty timeline. */
    static String of(List<TimedCommand> timeline) {
        List<String> words = new ArrayList<>();
        int others = 0;
        for (TimedCommand timed : timeline) {
            String word = word(timed.command());
            if (word.isEmpty() || words.size() == MAX_COMMANDS) {
                others++;
            } else {
                words.add(word + " at " + DecimalText.format(timed.time()) + " s");
            }
        }
        if (others > 0) {
            words.add(Html.count(others, words.isEmpty() ? "change" : "other change"));
        }
        return String.join(", ", words);
    }

    /** Returns a command in words; empty for one that is no switch, fault or repair. */
    private static String word(Command command) {
        return command.match(new Command.CommandCases<>(
                switched -> switched.sensor() + (switched.on() ? " switched on" : " switched off"),
                sensor -> "",
                broken -> broken.sensor()
                        + fault(
                                broken.fault().kind(),
                                broken.fault().value(),
                                broken.fault().length()),
                mended -> mended.sensor() + " without " + mended.fault().kind().fileName(),
                mended -> mended.sensor() + " without faults",
                broken -> broken.motor().fileName() + " motors"
                        + fault(broken.fault().kind(), broken.fault().value(), 0),
                mended -> mended.motor().fileName() + " motors without "
                        + mended.fault().kind().fileName(),
                mended -> mended.motor().fileName() + " motors without faults",
                moved -> "",
                placed -> "",
                removed -> "",
                platform -> "",
                controller -> ""));
    }

    private static String fault(FaultDescriptor<?> kind, double value, double length) {
        return " " + kind.fileName()
                + (kind.takesValue() ? "=" + DecimalText.format(value) : "")
                + (kind.takesLength() ? " of " + DecimalText.format(length) + " s" : "");
    }
}
