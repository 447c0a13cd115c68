//! What the quantities of columns are: their units, and what they follow from.

use super::curve::Measured;
use super::units::Quantity;

impl Measured {
    /// What its values are, where nothing is by depth.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::Displacement
            | Self::Position
            | Self::ContactGap
            | Self::GlueGap
            | Self::Thickness
            | Self::Level
            | Self::WetLength => Quantity::Length,
            Self::Reaction
            | Self::ContactForce
            | Self::GlueForce
            | Self::LinkForce
            | Self::JointForce
            | Self::Force
            | Self::BarForce
            | Self::SectionForce => Quantity::Force,
            Self::Rotation | Self::PrincipalAngle => Quantity::Angle,
            Self::Director
            | Self::Damage
            | Self::GreatestDepth
            | Self::PlasticStrain
            | Self::Pieces
            | Self::ReserveFactor
            | Self::FailureIndex => Quantity::Ratio,
            Self::TouchingArea => Quantity::Area,
            Self::Velocity => Quantity::Speed,
            Self::Acceleration => Quantity::Acceleration,
            Self::FractureEnergy
            | Self::FrictionLoss
            | Self::PlasticWork
            | Self::ContactMoment
            | Self::JointMoment
            | Self::Moment
            | Self::ReactionMoment
            | Self::SectionMoment
            | Self::BarMoment
            | Self::Energy => Quantity::Energy,
            Self::StrainEnergy
            | Self::Pressure
            | Self::EnclosedPressure
            | Self::Stress
            | Self::VonMises
            | Self::MaxPrincipal
            | Self::MinPrincipal
            | Self::Tresca
            | Self::PlyStress => Quantity::Stress,
            Self::EnclosedVolume => Quantity::Volume,
            Self::MembraneForce | Self::ShearForce => Quantity::ForcePerLength,
            Self::BendingMoment => Quantity::MomentPerLength,
            Self::Density => Quantity::Density,
            Self::Flux => Quantity::Flux,
            Self::Temperature => Quantity::Temperature,
            Self::HeldHeat => Quantity::HeatFlow,
        }
    }

    /// Whether it is a number without components.
    pub fn is_scalar(self) -> bool {
        matches!(
            self,
            Self::Damage
                | Self::FractureEnergy
                | Self::FrictionLoss
                | Self::PlasticStrain
                | Self::Thickness
                | Self::PlasticWork
                | Self::EnclosedPressure
                | Self::EnclosedVolume
                | Self::BarForce
                | Self::BarMoment
                | Self::Temperature
                | Self::HeldHeat
                | Self::ContactGap
                | Self::GreatestDepth
                | Self::TouchingArea
                | Self::Pieces
                | Self::StrainEnergy
                | Self::VonMises
                | Self::MaxPrincipal
                | Self::MinPrincipal
                | Self::Tresca
                | Self::PlyStress
                | Self::ReserveFactor
                | Self::FailureIndex
                | Self::Energy
                | Self::Pressure
                | Self::Density
                | Self::Level
                | Self::WetLength
                | Self::Flux
        )
    }

    /// Whether it is a stress, or made of one, that a homogeneous shell and a solid have alike.
    pub fn is_of_stress(self) -> bool {
        matches!(self, Self::VonMises | Self::Stress | Self::MaxPrincipal | Self::MinPrincipal | Self::Tresca)
    }

    /// Whether it follows from the stresses of plies.
    pub fn is_of_plies(self) -> bool {
        matches!(self, Self::PlyStress | Self::ReserveFactor | Self::FailureIndex)
    }

    /// Whether joints exert it.
    pub fn is_of_joints(self) -> bool {
        matches!(self, Self::JointForce | Self::JointMoment)
    }

    /// Whether it goes through a cut.
    pub fn is_of_section(self) -> bool {
        matches!(self, Self::SectionForce | Self::SectionMoment)
    }

    /// Whether it follows from the strains of a shell, where these are sampled.
    pub fn is_of_strains(self) -> bool {
        let forces =
            matches!(self, Self::MembraneForce | Self::BendingMoment | Self::ShearForce | Self::Energy);
        forces || self.is_of_stress() || self.is_of_plies() || self == Self::PrincipalAngle
    }

    /// Whether a column of its mean since the last record stands beside it: an impact shorter than that is lost to instants.
    pub fn has_mean(self) -> bool {
        matches!(self, Self::Force | Self::Moment)
    }

    /// Whether it is what a fluid does to its boundary, not what the boundary itself has.
    pub fn is_of_contact(self) -> bool {
        matches!(self, Self::Pressure | Self::Level | Self::WetLength | Self::Force | Self::Moment)
    }
}
