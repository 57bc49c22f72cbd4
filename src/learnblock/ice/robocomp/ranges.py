"""Distance sensors: Laser and Ultrasound."""

from dataclasses import dataclass

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.robocomp.bases import base_state
from learnblock.ice.robocomp.layout import Layout, laid_out
from learnblock.ice.types import STRING, Float, Int, Refusal, Sequence, String, Structure


@dataclass(frozen=True, slots=True)
class LaserReading:
    """A distance (TData): angle in rad or a sensor's number; dist in mm."""

    angle: Float = 0.0
    dist: Float = 0.0


@dataclass(frozen=True, slots=True)
class LaserConfData:
    """The parameters of a laser: mm, degrees, ms."""

    staticConf: Int = 0
    maxMeasures: Int = 0
    maxDegrees: Int = 0
    maxRange: Int = 0
    minRange: Int = 0
    iniRange: Int = 0
    endRange: Int = 0
    cluster: Int = 0
    sampleRate: Int = 0
    angleRes: Float = 0.0
    angleIni: Float = 0.0
    driver: String = ""
    device: String = ""


@dataclass(frozen=True, slots=True)
class UltrasoundBusParams:
    """The bus of ultrasonic sensors (Ultrasound's BusParams)."""

    numSensors: Int = 0
    baudRate: Int = 0
    basicPeriod: Int = 0


@dataclass(frozen=True, slots=True)
class SensorData:
    """A reading of an ultrasonic sensor."""

    dist: Float = 0.0
    ang: Float = 0.0


_CONFIGURATION_ORDERS = {
    Layout.SINCE_2020: (
        "driver device staticConf maxMeasures maxDegrees maxRange minRange iniRange endRange"
        " cluster sampleRate angleRes angleIni"
    ),
}


def laser(layout: Layout) -> Interface:
    """A laser, or a row of distance sensors with the same interface."""
    readings = Sequence(Structure.of(LaserReading))
    configuration = laid_out(LaserConfData, layout, _CONFIGURATION_ORDERS)
    return Interface(
        "::RoboCompLaser::Laser",
        (
            Operation("getLaserData", gives=(readings,)),
            Operation("getLaserAndBStateData", gives=(base_state(layout), readings)),
            Operation("getLaserConfData", gives=(configuration,)),
        ),
    )


def ultrasound() -> Interface:
    """Ultrasonic sensors."""
    unknown = Refusal("::RoboCompUltrasound::UnknownSensorException")
    reading = Structure.of(SensorData)
    return Interface(
        "::RoboCompUltrasound::Ultrasound",
        (
            Operation("getBusParams", gives=(Structure.of(UltrasoundBusParams),)),
            Operation("getSensorData", takes=(STRING,), gives=(reading,), refuses=(unknown,)),
            Operation("getAllSensorData", gives=(STRING,)),
        ),
    )
