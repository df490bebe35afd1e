package faultline.campaign.plan;

import faultline.io.MessageText;
import faultline.scenario.xml.Problems;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Finds attributes that two elements of a plan set. Only one of the values would be effective, and the column of the
 * other one would show values that no run had.
 */
final class AttributeConflicts {

    private final Problems problems;
    private final Set<AttributePath> constant = new HashSet<>();
    private final Set<AttributePath> varied = new HashSet<>();

    private AttributeConflicts(Problems problems) {
        this.problems = problems;
    }

    /** Reports each attribute that is set twice. Variants and masks may replace a constant value. */
    static void report(List<ScenarioChange> constants, List<Factor> factors, Problems problems) {
        AttributeConflicts conflicts = new AttributeConflicts(problems);
        constants.forEach(change -> conflicts.add(change, conflicts.constant));
        factors.forEach(conflicts::add);
    }

    private void add(Factor factor) {
        Map<AttributePath, ScenarioChange> first = new LinkedHashMap<>();
        for (Factor.Level level : factor.levels()) {
            Set<AttributePath> inLevel = new HashSet<>();
            for (ScenarioChange change : level.edits()) {
                if (change instanceof ScenarioChange.SetAttribute set) {
                    add(set, inLevel);
                    first.putIfAbsent(set.path(), set);
                }
            }
        }
        first.forEach((path, change) -> {
            if (factor.kind() == FactorKind.SET && constant.contains(path)) {
                report(path, change);
            } else {
                add(change, varied);
            }
        });
    }

    private void add(ScenarioChange change, Set<AttributePath> paths) {
        if (change instanceof ScenarioChange.SetAttribute set && !paths.add(set.path())) {
            report(set.path(), set);
        }
    }

    private void report(AttributePath path, ScenarioChange change) {
        problems.add(change.location(), PlanProblem.DUPLICATE_ATTRIBUTE.with(MessageText.excerpt(path.toString())));
    }
}
