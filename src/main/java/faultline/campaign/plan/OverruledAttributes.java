package faultline.campaign.plan;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Finds what a plan sets of the controller although a change of the controller in a timeline sets it again. */
final class OverruledAttributes {

    private final Set<String> setByPlan = new TreeSet<>();

    OverruledAttributes(List<ScenarioChange> constants, List<Factor> factors) {
        Stream.concat(
                        constants.stream(),
                        factors.stream()
                                .flatMap(factor -> factor.settingLevels().stream())
                                .flatMap(level -> level.edits().stream()))
                .filter(ScenarioChange.SetAttribute.class::isInstance)
                .map(change -> ((ScenarioChange.SetAttribute) change).path())
                .filter(AttributePath::isOfController)
                .forEach(path -> setByPlan.add(path.attribute()));
    }

    /** Returns the names of the attributes that the plan and the timeline of a scenario set, sorted. */
    List<String> in(WorldSource.ScenarioFile scenario) {
        return setByPlan.stream()
                .filter(scenario.timelineControllerAttributes()::contains)
                .toList();
    }
}
